#include <libhair/files/usda/usda_file.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <libhair/files/byte_reader.h>
#include <libhair/files/usda/usda_transform.h>

namespace hair {

namespace {

using Basis = UsdaCurveKind::Basis;
using Wrap = UsdaCurveKind::Wrap;

// Text of USD it is, before anything else is read.
UsdaScanner& expectText(std::istream& stream, UsdaScanner& in) {
  char magic[8] = {};
  stream.read(magic, sizeof magic);
  const std::string_view start(magic, static_cast<std::size_t>(stream.gcount()));
  in.expect(!start.starts_with("PXR-USDC"),
            "this is a binary USD file; turn it into text (usdcat -o out.usda) first");
  in.expect(!start.starts_with("PK"),
            "this is a packed USD file (.usdz); turn it into text (usdcat -o out.usda) first");
  in.expect(start.starts_with("#usda "), "'#usda 1.0' expected: this is no USD text file");
  stream.clear();
  stream.seekg(0);
  return in;
}

glm::vec3 transformed(const glm::dmat4& m, glm::vec3 p) {
  return glm::vec3(m * glm::dvec4(p, 1));
}

// Sum of a curve's values at a point.
template <class T>
T valueAt(const UsdaCurvePoint& point, const T* values) {
  T sum = point.weight[0] * values[point.vertex[0]];
  for (std::size_t k = 1; k < 4; ++k)
    if (point.weight[k] != 0) sum += point.weight[k] * values[point.vertex[k]];
  return sum;
}

// Values of one prim behind those of others, where either may be one value for all points.
template <class T>
void join(std::vector<T>& all, T& constant, std::size_t points, const std::vector<T>& more,
          const T& moreConstant, std::size_t morePoints) {
  if (points == 0) constant = moreConstant;
  if (all.empty() && more.empty() && constant == moreConstant) return;
  if (all.empty()) all.assign(points, constant);
  if (more.empty())
    all.resize(points + morePoints, moreConstant);
  else
    all.insert(all.end(), more.begin(), more.end());
  constant = T(0);
}

}  // namespace

UsdaReader::UsdaReader(std::istream& stream, std::string_view name, std::string_view prim)
    : in_(stream, name), layer_(expectText(stream, in_)) {
  findCurves(prim);
  for (const Curves& curves : curves_) {
    if (curves.points->animated)
      for (const UsdaLayer::Sample& sample : curves.points->samples) times_.push_back(sample.time);
    addTransformTimes(layer_, curves.prim, times_);
  }
  std::sort(times_.begin(), times_.end());
  times_.erase(std::unique(times_.begin(), times_.end()), times_.end());
}

bool UsdaReader::isHidden(std::size_t prim) const {
  for (std::size_t p = prim; p != UsdaLayer::kNone; p = layer_.prims[p].parent)
    if (!layer_.prims[p].active || layer_.prims[p].token("visibility", "") == "invisible")
      return true;
  return false;
}

void UsdaReader::findCurves(std::string_view wanted) {
  std::vector<std::size_t> found;
  std::string others, hidden, all;
  for (std::size_t i = 0; i < layer_.prims.size(); ++i) {
    const UsdaLayer::Prim& prim = layer_.prims[i];
    if (prim.defined && (prim.type == "NurbsCurves" || prim.type == "HermiteCurves"))
      others = text("; ", prim.type, " ", TextReader::shown(prim.name), " are not read");
    if (!prim.defined || prim.type != "BasisCurves") continue;
    const std::string path = layer_.pathOf(i);
    if (all.size() < 1000) all += (all.empty() ? "" : ", ") + TextReader::shown(path);
    // `wanted` is in the path, whole names of it.
    const bool chosen =
        wanted.empty() ||
        (wanted.starts_with('/') ? (path + '/').starts_with(std::string(wanted) + '/')
                                 : (path + '/').find('/' + std::string(wanted) + '/') != path.npos);
    if (!chosen) continue;
    if (wanted.empty() && isHidden(i))
      hidden = text("; ", TextReader::shown(prim.name), " is invisible or inactive (--prim)");
    else
      found.push_back(i);
  }
  in_.expect(!found.empty() || wanted.empty() || all.empty(), "no BasisCurves at --prim ",
             TextReader::shown(wanted), "; there are ", all);
  in_.expect(!found.empty(), "the file ends without a BasisCurves prim", others, hidden,
             layer_.refersToOthers ? "; references to other files are not followed" : "");
  // Programs write empty ones too.
  const auto empty = [&](std::size_t prim) {
    return !layer_.prims[prim].find("points") || !layer_.prims[prim].find("curveVertexCounts");
  };
  if (!std::all_of(found.begin(), found.end(), empty)) std::erase_if(found, empty);
  for (const std::size_t prim : found) addCurves(prim);
}

void UsdaReader::addCurves(std::size_t index) {
  const UsdaLayer::Prim& prim = layer_.prims[index];
  const std::string shown = TextReader::shown(prim.name);
  Curves curves{
      index, layer_.pathOf(index), {}, prim.find("curveVertexCounts"), prim.find("points"), {}, {},
      {}};
  in_.expect(curves.counts != nullptr, "BasisCurves ", shown, " has no curveVertexCounts");
  in_.expect(curves.points != nullptr, "BasisCurves ", shown, " has no points");
  const std::string_view type = prim.token("type", "cubic"), basis = prim.token("basis", "bezier"),
                         wrap = prim.token("wrap", "nonperiodic");
  in_.expect(type == "linear" || type == "cubic", "BasisCurves ", shown, " is of type '",
             TextReader::shown(type), "'; linear and cubic curves are read");
  if (type == "cubic") {
    in_.expect(basis == "bezier" || basis == "bspline" || basis == "catmullRom", "BasisCurves ",
               shown, " has the basis '", TextReader::shown(basis),
               "'; bezier, bspline and catmullRom are read");
    curves.kind.basis = basis == "bezier"    ? Basis::Bezier
                        : basis == "bspline" ? Basis::BSpline
                                             : Basis::CatmullRom;
  }
  in_.expect(wrap == "nonperiodic" || wrap == "periodic" || wrap == "pinned", "BasisCurves ", shown,
             " has the wrap '", TextReader::shown(wrap),
             "'; nonperiodic, periodic and pinned are read");
  curves.kind.wrap = wrap == "periodic" ? Wrap::Periodic
                     : wrap == "pinned" ? Wrap::Pinned
                                        : Wrap::Nonperiodic;
  curves.widths = primvarOf(index, "widths");
  if (!curves.widths.values) curves.widths = primvarOf(index, "primvars:widths");
  curves.colours = primvarOf(index, "primvars:displayColor");
  curves.opacity = primvarOf(index, "primvars:displayOpacity");
  curves_.push_back(std::move(curves));
}

// Primvars reach the prims below.
UsdaReader::Primvar UsdaReader::primvarOf(std::size_t prim, std::string_view name) const {
  const std::string indices = std::string(name) + ":indices";
  for (std::size_t p = prim; p != UsdaLayer::kNone; p = layer_.prims[p].parent) {
    if (const Attribute* values = layer_.prims[p].find(name))
      return {values, layer_.prims[p].find(indices)};
    if (!name.starts_with("primvars:")) break;
  }
  return {};
}

std::size_t UsdaReader::frameCount() const {
  return std::max<std::size_t>(times_.size(), 1);
}

double UsdaReader::timeCode(std::size_t frame) const {
  return times_.empty() ? 0 : times_[frame];
}

double UsdaReader::codesPerSecond() const {
  if (times_.empty()) return 0;
  if (layer_.codesPerSecond > 0) return layer_.codesPerSecond;
  return layer_.framesPerSecond > 0 ? layer_.framesPerSecond : 24;  // USD's fallback
}

double UsdaReader::seconds(std::size_t frame) const {
  return times_.empty() ? 0 : (timeCode(frame) - layer_.start) / codesPerSecond();
}

// To the last sample up to that time, or else the first.
void UsdaReader::goTo(const Attribute& attribute, double time) {
  in_.goTo(samplesAround(attribute, time).before);
}

template <class Item>
void UsdaReader::readArray(std::string_view what, Item&& item) {
  in_.expect(in_.takeSign('['), what, ": '[' expected");
  while (!in_.takeSign(']')) {
    item();
    if (in_.takeSign(',')) continue;
    in_.expect(in_.takeSign(']'), what, ": ',' or ']' expected");
    break;
  }
}

glm::vec3 UsdaReader::vec3(std::string_view what) {
  glm::vec3 v;
  in_.expect(in_.takeSign('('), what, ": '(' expected");
  for (int c = 0; c < 3; ++c) {
    in_.expect(c == 0 || in_.takeSign(','), what, ": three numbers expected");
    v[c] = in_.number(what);
  }
  in_.expect(in_.takeSign(')'), what, ": ')' expected");
  return v;
}

void UsdaReader::readPoints(const Curves& curves, double time, std::vector<glm::vec3>& points) {
  const auto [before, after, t] = samplesAround(*curves.points, time);
  points.clear();
  in_.goTo(before);
  readArray("points", [&] { points.push_back(vec3("points")); });
  if (t == 0) return;
  std::vector<glm::vec3> next;
  in_.goTo(after);
  readArray("points", [&] { next.push_back(vec3("points")); });
  if (next.size() != points.size()) return;  // other strands: held
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = glm::mix(points[i], next[i], static_cast<float>(t));
}

UsdaReader::Shape UsdaReader::shapeOf(const Curves& curves, const StrandSet& vertices) const {
  Shape shape;
  shape.first = vertices.first;
  if (curves.kind.basis == Basis::Linear && curves.kind.wrap != Wrap::Periodic) {
    shape.firstVarying = vertices.first;
    return shape;
  }
  const bool stated = layer_.prims[curves.prim].tokens.contains("type");
  // Hair has many curves of few kinds.
  std::map<std::uint32_t, std::vector<UsdaCurvePoint>> known;
  for (std::size_t s = 0; s < vertices.strandCount(); ++s) {
    const std::uint32_t n = vertices.first[s + 1] - vertices.first[s];
    const auto [at, isNew] = known.try_emplace(n);
    if (isNew) {
      at->second = pointsOfCurve(curves.kind, n);
      if (at->second.empty() && !stated) at->second = pointsOfCurve({}, n);
      in_.expect(!at->second.empty() || n == 0, "curve ", s, " of ", TextReader::shown(curves.path),
                 " has ", n,
                 " vertices; a Bezier curve has 4, 7, 10 and so on, a closed one 3, 6, 9");
    }
    shape.points.insert(shape.points.end(), at->second.begin(), at->second.end());
    shape.curveOf.resize(shape.points.size(), static_cast<std::uint32_t>(s));
    shape.firstVarying.push_back(shape.firstVarying.back() + varyingOfCurve(curves.kind, n));
  }
  in_.expect(shape.points.size() <= 0xffffffffu, "more than 2^32 - 1 points on cubic curves");
  return shape;
}

// One value a point of the strands, of however many the file has; or the one for all.
template <class T, class Item>
void UsdaReader::readPrimvar(const Primvar& primvar, std::string_view what, double time,
                             const Shape& shape, std::vector<T>& items, T& constant, Item&& item) {
  items.clear();
  constant = T(0);
  if (!primvar.values) return;
  std::vector<T> values;
  goTo(*primvar.values, time);
  readArray(what, [&] { values.push_back(item()); });
  if (primvar.indices) {
    const std::vector<T> distinct = std::move(values);
    values.clear();
    goTo(*primvar.indices, time);
    readArray(what, [&] {
      const long long i = in_.integer(what);
      in_.expect(i >= 0 && static_cast<unsigned long long>(i) < distinct.size(), what, ": index ",
                 i, " of ", distinct.size(), " values");
      values.push_back(distinct[static_cast<std::size_t>(i)]);
    });
  }
  if (values.empty()) return;
  const std::string& stated = primvar.values->interpolation;
  const std::size_t count = values.size(), curves = shape.first.size() - 1,
                    vertices = shape.first.back(), varying = shape.firstVarying.back();
  const auto are = [&](std::string_view kind, std::size_t wanted) {
    return count == wanted && (stated.empty() || stated == kind);
  };
  if (are("constant", 1)) {
    constant = values[0];
  } else if (are("vertex", vertices) && shape.points.empty()) {
    items = std::move(values);
  } else if (are("vertex", vertices)) {
    for (std::size_t i = 0; i < shape.points.size(); ++i)
      items.push_back(valueAt(shape.points[i], values.data() + shape.first[shape.curveOf[i]]));
  } else if (are("varying", varying) && shape.points.empty()) {
    items = std::move(values);
  } else if (are("varying", varying)) {
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
      const UsdaCurvePoint& point = shape.points[i];
      const T* curve = values.data() + shape.firstVarying[shape.curveOf[i]];
      items.push_back((1 - point.t) * curve[point.varying] + point.t * curve[point.nextVarying]);
    }
  } else {
    in_.expect(are("uniform", curves) || stated != "uniform", what, ": ", count, " values for ",
               curves, " curves");
    in_.expect(
        are("uniform", curves) || stated.empty() || stated == "vertex" || stated == "varying", what,
        ": interpolation '", TextReader::shown(stated), "' does not fit ", count, " values");
    in_.expect(are("uniform", curves), what, ": ", count, " values for ", vertices, " points");
    if (shape.points.empty())
      for (std::size_t s = 0; s < curves; ++s) items.resize(shape.first[s + 1], values[s]);
    else
      for (const std::uint32_t s : shape.curveOf) items.push_back(values[s]);
  }
}

// Into the stage's space. Replaces all of `out` but what concerns the file.
void UsdaReader::readCurves(const Curves& curves, double time, StrandFile& out) {
  StrandSet& strands = out.strands;
  strands.first.assign(1, 0);
  goTo(*curves.counts, time);
  readArray("curveVertexCounts", [&] {
    const long long count = in_.integer("curveVertexCounts");
    in_.expect(count >= 0 && count <= 0xffffffffll - strands.first.back(), "curve ",
               strands.strandCount(), " has ", count, " points");
    strands.first.push_back(strands.first.back() + static_cast<std::uint32_t>(count));
  });
  readPoints(curves, time, strands.points);
  in_.expect(strands.pointCount() == strands.first.back(), "curveVertexCounts ask for ",
             strands.first.back(), " points, there are ", strands.pointCount());

  const Shape shape = shapeOf(curves, strands);
  readPrimvar(curves.widths, "widths", time, shape, out.thickness, out.defaultThickness,
              [&] { return in_.number("widths"); });
  readPrimvar(curves.colours, "displayColor", time, shape, out.colours, out.defaultColour,
              [&] { return vec3("displayColor"); });
  readPrimvar(curves.opacity, "displayOpacity", time, shape, out.transparency,
              out.defaultTransparency, [&] { return 1 - in_.number("displayOpacity"); });

  if (!shape.points.empty()) {
    const std::vector<glm::vec3> vertices = std::move(strands.points);
    strands.points.clear();
    strands.first.assign(shape.first.size(), 0);
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
      const std::uint32_t s = shape.curveOf[i];
      strands.points.push_back(valueAt(shape.points[i], vertices.data() + shape.first[s]));
      strands.first[s + 1] = static_cast<std::uint32_t>(i + 1);
    }
    for (std::size_t s = 1; s < strands.first.size(); ++s)
      strands.first[s] = std::max(strands.first[s], strands.first[s - 1]);
  }

  const glm::dmat4 stageFromCurves = stageFromPrim(in_, layer_, curves.prim, time);
  if (stageFromCurves == glm::dmat4(1)) return;
  for (glm::vec3& p : strands.points) p = transformed(stageFromCurves, p);
  const auto larger =
      static_cast<float>(std::cbrt(std::abs(glm::determinant(glm::dmat3(stageFromCurves)))));
  for (float& t : out.thickness) t *= larger;
  out.defaultThickness *= larger;
  bool finite = std::isfinite(out.defaultThickness);
  for (const glm::vec3& p : strands.points) finite = finite && std::isfinite(p.x + p.y + p.z);
  for (const float t : out.thickness) finite = finite && std::isfinite(t);
  in_.expect(finite, "the transforms of ", TextReader::shown(curves.path),
             " take points beyond all numbers");
}

void UsdaReader::read(std::size_t frame, StrandFile& out) {
  require(frame < frameCount(), "frame ", frame, " of ", frameCount());
  const double time = timeCode(frame);
  out.notes = layer_.notes;
  if (curves_.size() == 1) {
    readCurves(curves_[0], time, out);
  } else {
    std::string paths;
    out.strands.points.clear();
    out.strands.first.assign(1, 0);
    out.thickness.clear();
    out.transparency.clear();
    out.colours.clear();
    for (const Curves& curves : curves_) {
      readCurves(curves, time, part_);
      const std::size_t points = out.strands.pointCount(), more = part_.strands.pointCount();
      in_.expect(points + more <= 0xffffffffu, "more than 2^32 - 1 points in all");
      join(out.thickness, out.defaultThickness, points, part_.thickness, part_.defaultThickness,
           more);
      join(out.transparency, out.defaultTransparency, points, part_.transparency,
           part_.defaultTransparency, more);
      join(out.colours, out.defaultColour, points, part_.colours, part_.defaultColour, more);
      out.strands.points.insert(out.strands.points.end(), part_.strands.points.begin(),
                                part_.strands.points.end());
      for (std::size_t s = 1; s < part_.strands.first.size(); ++s)
        out.strands.first.push_back(static_cast<std::uint32_t>(points) + part_.strands.first[s]);
      if (paths.size() < 200) paths += (paths.empty() ? "" : ", ") + TextReader::shown(curves.path);
    }
    out.notes.push_back(text(curves_.size(), " prims joined: ", paths, " (--prim chooses)"));
  }
  in_.expect(out.strands.strandCount() > 0, "the file holds no strands");
  out.format = "usda";
  out.arrays = "points";
  out.scale = layer_.metersPerUnit;
  out.up = layer_.up;
}

StrandFile readUsda(const std::filesystem::path& file, const ReadOptions& options) {
  std::ifstream stream = openFile(file);
  UsdaReader reader(stream, file.string(), options.prim);
  StrandFile strands;
  reader.read(0, strands);
  return strands;
}

}  // namespace hair
