// Strands in NumPy arrays, and the files they come from.
#include "strands.h"

#include <optional>

#include <libhair/core/error.h>
#include <libhair/files/strand_file.h>
#include <libhair/files/strand_sequence.h>
#include <libhair/model/resample.h>

#include "choices.h"
#include "topics.h"

namespace hair::python {

Strands::Strands(const py::object& points_, const py::object& first_) {
  if (!first_.is_none()) {
    points = requirePoints(points_, "points");
    first = requireArray(first_, "first", py::dtype::of<std::uint32_t>(), {kAny});
  } else {
    const py::array grid = requireArray(points_, "points", py::dtype::of<float>(), {kAny, kAny, 3});
    const py::ssize_t count = grid.shape(0), each = grid.shape(1);
    // Without points there is no bound on the strands, whose offsets would fill the memory.
    if (count > 0 && each == 0)
      throw py::value_error(text("points: ", count, " strands of no points"));
    if (count * each > py::ssize_t{0xffffffff}) throw py::value_error("points: more than 2^32 - 1");
    // Of a contiguous array, reshape is a view.
    points = grid.attr("reshape")(-1, 3);
    std::vector<std::uint32_t> offsets;
    for (py::ssize_t s = 0; s <= count; ++s)
      offsets.push_back(static_cast<std::uint32_t>(s * each));
    first = arrayOf<std::uint32_t>(std::move(offsets), {count + 1});
  }
  view();
}

Strands::Strands(StrandSet strands) {
  const auto count = static_cast<py::ssize_t>(strands.first.size());
  points = arrayOfPoints(std::move(strands.points));
  first = arrayOf<std::uint32_t>(std::move(strands.first), {count});
}

StrandView Strands::view(std::size_t minPoints) const {
  const StrandView strands = unchecked();
  validate(strands, "strands", minPoints);
  return strands;
}

namespace {

StrandSet copyOf(const Strands& strands) {
  const StrandView view = strands.view();
  return {{view.points.begin(), view.points.end()}, {view.first.begin(), view.first.end()}};
}

py::object strandOf(const Strands& strands, py::ssize_t s) {
  const auto count = static_cast<py::ssize_t>(strands.strandCount());
  if (s < -count || s >= count) throw py::index_error(text("strand ", s, " of ", count));
  const auto at = static_cast<std::size_t>(s < 0 ? s + count : s);
  const auto first = spanOf<const std::uint32_t, std::uint32_t>(strands.first);
  return strands.points[py::slice(static_cast<py::ssize_t>(first[at]),
                                  static_cast<py::ssize_t>(first[at + 1]), 1)];
}

py::array rootsOf(const Strands& strands) {
  const StrandView view = strands.view();
  std::vector<glm::vec3> roots;
  for (std::size_t s = 0; s < view.strandCount(); ++s) roots.push_back(view.strand(s).front());
  return arrayOfPoints(std::move(roots));
}

py::array lengthsOf(const Strands& strands) {
  const StrandView view = strands.view();
  std::vector<float> lengths;
  for (std::size_t s = 0; s < view.strandCount(); ++s) lengths.push_back(arcLength(view.strand(s)));
  const auto count = static_cast<py::ssize_t>(lengths.size());
  return arrayOf<float>(std::move(lengths), {count});
}

Strands resampled(const Strands& strands, std::size_t count, std::size_t points) {
  const StrandView view = strands.view();
  const std::size_t wanted = count > 0 ? count : view.strandCount();
  return Strands(withoutLock([&] {
    const ResamplePlan plan =
        planResampling(view, chooseStrands(view.strandCount(), wanted), points);
    return StrandSet{resample(plan, std::vector(view.points.begin(), view.points.end())),
                     plan.first};
  }));
}

/// A StrandFile whose arrays are Python's.
struct File {
  StrandFile rest;  ///< without strands
  Strands strands;
  py::object thickness, transparency, colours;  ///< arrays or None

  explicit File(StrandFile file) : strands(std::move(file.strands)) {
    thickness = orNone<float>(std::move(file.thickness), 1);
    transparency = orNone<float>(std::move(file.transparency), 1);
    colours = orNone<float>(std::move(file.colours), 3);
    rest = std::move(file);
  }

  StrandFile toWrite() const {
    StrandFile file = rest;
    file.strands = copyOf(strands);
    file.thickness = itemsOf<float>(thickness);
    file.transparency = itemsOf<float>(transparency);
    file.colours = itemsOf<glm::vec3>(colours);
    return file;
  }

 private:
  template <class Scalar, class T>
  static py::object orNone(std::vector<T> items, py::ssize_t columns) {
    if (items.empty()) return py::none();
    const auto count = static_cast<py::ssize_t>(items.size());
    return arrayOf<Scalar>(std::move(items), columns == 1 ? Shape{count} : Shape{count, columns});
  }
  template <class T>
  static std::vector<T> itemsOf(const py::object& array) {
    if (array.is_none()) return {};
    const auto items = spanOf<const T, float>(py::reinterpret_borrow<py::array>(array));
    return {items.begin(), items.end()};
  }
};

void bindFiles(py::module_& m) {
  py::class_<File>(m, "StrandFile",
                   "Strands of a file in metres, +Y up, +Z face, and what it says of them.")
      .def_readonly("strands", &File::strands, "Strands; short ones are kept.")
      .def_property_readonly(
          "format", [](const File& f) { return f.rest.format; }, "\"hair\", \"tfx\", \"data\" ...")
      .def_property_readonly(
          "arrays", [](const File& f) { return f.rest.arrays; }, "What the file holds, in words.")
      .def_property_readonly(
          "scale", [](const File& f) { return f.rest.scale; }, "Metres per unit that was applied.")
      .def_property_readonly(
          "up", [](const File& f) { return f.rest.up; }, "Axes that were assumed.")
      .def_property_readonly(
          "notes", [](const File& f) { return f.rest.notes; },
          "What the reader chose or assumed, a sentence each.")
      .def_readonly("thickness", &File::thickness, "(N,) float32 diameters, metres, or None.")
      .def_readonly("transparency", &File::transparency, "(N,) float32, 0 opaque, or None.")
      .def_readonly("colours", &File::colours, "(N, 3) float32 linear RGB, or None.")
      .def_property_readonly(
          "default_thickness", [](const File& f) { return f.rest.defaultThickness; },
          "Metres, where there is no array; 0: not stated.")
      .def_property_readonly(
          "default_transparency", [](const File& f) { return f.rest.defaultTransparency; },
          "Where there is no array.")
      .def_property_readonly(
          "default_colour", [](const File& f) { return f.rest.defaultColour; },
          "Linear RGB where there is no array; black: not stated.")
      .def("__repr__", [](const File& f) {
        return text("<StrandFile ", f.rest.format, ": ", f.strands.strandCount(), " strands, ",
                    f.rest.arrays, ">");
      });

  m.def(
      "read_strands",
      [](const std::filesystem::path& path, float scale, UpAxis up, const std::string& prim,
         std::uint32_t pointsPerStrand) {
        return File(
            withoutLock([&] { return readStrands(path, {scale, up, prim, pointsPerStrand}); }));
      },
      py::arg("path"), py::arg("scale") = 0.0f, py::arg("up") = UpAxis::AsFile,
      py::arg("prim") = "", py::arg("points_per_strand") = 0,
      R"(Reads a file of strands; its extension says which format.

scale: metres per unit of the file, 0: the format's default. up: which axis of the file points up.
prim: of several curves in a .usda, those of this path or name. points_per_strand: of a cloud of
points without edges; 0: as their spacing shows. Error names file, place and cause.)");
  m.def(
      "write_strands",
      [](const std::filesystem::path& path, const Strands& strands) {
        const StrandView view = strands.view();
        withoutLock([&] { writeStrands(path, view); });
      },
      py::arg("path"), py::arg("strands"),
      "Writes a file of strands, the whole file or nothing; its extension says which format.");
  m.def(
      "write_strands",
      [](const std::filesystem::path& path, const File& file) {
        const StrandFile whole = file.toWrite();
        withoutLock([&] { writeStrands(path, whole); });
      },
      py::arg("path"), py::arg("strands"), "The same with the file's arrays.");
}

/// Frames of strands into one file or numbered ones; closed by hand or by `with`.
class SequenceWriter {
 public:
  SequenceWriter(const std::filesystem::path& path, double fps, long long firstFrame)
      : path_(path),
        writer_(std::in_place, path, SequenceOptions{.fps = fps, .firstFrame = firstFrame}) {}

  void add(const Strands& strands) {
    const StrandView view = strands.view();
    open();
    const Busy busy(busy_, "sequence");
    withoutLock([&] { writer_->add(view); });
  }
  void close() {
    open();
    const Busy busy(busy_, "sequence");
    withoutLock([&] { writer_->close(); });
    writer_.reset();
  }
  std::string repr() const {
    return text("<StrandSequenceWriter ", path_, writer_ ? ">" : ", closed>");
  }
  void leave(bool failed) {
    if (!writer_) return;
    if (!failed) return close();
    const Busy busy(busy_, "sequence");
    writer_.reset();
  }

 private:
  void open() const {
    if (!writer_) throw py::value_error("the sequence is closed");
  }

  std::filesystem::path path_;
  std::optional<StrandSequenceWriter> writer_;
  bool busy_ = false;
};

void bindSequences(py::module_& m) {
  py::class_<SequenceWriter>(
      m, "StrandSequenceWriter",
      R"(Writes moving strands, frame after frame, in the memory of one frame.

path: shot.usda is one file with a time sample a frame, shot.####.hair a file a frame, in any format.
first_frame: number or time code of the first; fps: time codes a second. One file appears under its
name when it is closed: use it in a with statement, which leaves nothing behind where its body
throws.)")
      .def(py::init<const std::filesystem::path&, double, long long>(), py::arg("path"),
           py::kw_only(), py::arg("fps") = SequenceOptions{}.fps,
           py::arg("first_frame") = SequenceOptions{}.firstFrame,
           "Error for a format that holds one frame only and a name without #.")
      .def("add", &SequenceWriter::add, py::arg("strands").none(false),
           "The next frame; in one file, strands of as many points as in the first.")
      .def("__repr__", &SequenceWriter::repr, "Its file, and whether it is closed.")
      .def("close", &SequenceWriter::close, "After the last frame; none is an Error.")
      .def(
          "__enter__", [](SequenceWriter& w) -> SequenceWriter& { return w; }, "Itself.",
          py::return_value_policy::reference)
      .def(
          "__exit__",
          [](SequenceWriter& w, const py::object& type, const py::object&, const py::object&) {
            w.leave(!type.is_none());
          },
          py::arg("type"), py::arg("value"), py::arg("traceback"),
          "Closes it, or leaves no file where the body threw.");
}

}  // namespace

void bindStrands(py::module_& m) {
  py::class_<Strands>(m, "Strands", R"(Strands, root first, in two arrays that are used in place.

points: (N, 3) float32, metres. first: (S + 1,) uint32; strand s is points[first[s]:first[s + 1]].
Or points (S, P, 3) float32 alone: S strands of P points. Neither is copied: what is written into
them later, the next call sees. They must not be written while a call works on them.)")
      .def(
          py::init<const py::object&, const py::object&>(), py::arg("points"),
          py::arg("first") = py::none(),
          "TypeError or ValueError for arrays of another type or shape, Error for what is no hair.")
      .def_readonly("points", &Strands::points, "(N, 3) float32, metres: the array itself.")
      .def_readonly("first", &Strands::first, "(S + 1,) uint32: the array itself.")
      .def_property_readonly("strand_count", &Strands::strandCount, "S.")
      .def_property_readonly(
          "point_count", [](const Strands& s) { return s.points.shape(0); }, "N.")
      .def("__len__", &Strands::strandCount, "S.")
      .def("__getitem__", &strandOf, py::arg("strand"), "A view of one strand, (P, 3) float32.")
      .def(
          "__iter__",
          [](const Strands& strands) {
            py::list views;
            for (std::size_t s = 0; s < strands.strandCount(); ++s)
              views.append(strandOf(strands, static_cast<py::ssize_t>(s)));
            return py::iter(views);
          },
          "Views of all strands, one after the other.")
      .def("roots", &rootsOf, "First points, (S, 3) float32; a copy.")
      .def("lengths", &lengthsOf, "Along the polylines, (S,) float32, metres.")
      .def(
          "validate", [](const Strands& s, std::size_t points) { s.view(points); },
          py::arg("min_points") = 1,
          "Error unless offsets fit, all is finite and strands have as many points. Every call "
          "that "
          "takes strands looks for itself.")
      .def("resampled", &resampled, py::arg("count") = 0, py::arg("points") = 0,
           R"(Some of the strands with another number of points; new arrays.

count: strands, a choice that looks random and is always the same; 0: all. points: of a strand,
evenly along its length; 0: those it has.)")
      .def(
          "without_degenerate",
          [](const Strands& strands, float minLength, std::size_t minPoints) {
            StrandSet copy = copyOf(strands);
            dropDegenerate(copy, minLength, minPoints);
            return Strands(std::move(copy));
          },
          py::arg("min_length") = 1e-3f, py::arg("min_points") = 2,
          "A copy without strands shorter than min_length (metres) or of fewer points.")
      .def("__repr__", [](const Strands& s) {
        return text("<Strands: ", s.strandCount(), " strands, ", s.points.shape(0), " points>");
      });
  bindFiles(m);
  bindSequences(m);
}

}  // namespace hair::python
