#pragma once

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include <libhair/files/strand_file.h>
#include <libhair/files/usda/usda_curves.h>
#include <libhair/files/usda/usda_layer.h>
#include <libhair/files/usda/usda_scanner.h>

namespace hair {

/// Strands in USD's text format, as prims of the schema UsdGeomBasisCurves
/// (openusd.org/release/api/class_usd_geom_basis_curves.html and the pages named here):
///
///   type, basis, wrap                   BasisCurves: linear or cubic (bezier, bspline,
///   catmullRom),
///                                       nonperiodic, periodic or pinned; the fallbacks are cubic,
///                                       bezier, nonperiodic. Written: linear, nonperiodic
///   curveVertexCounts                   UsdGeomCurves: vertices of each curve, at least 2
///   points                              UsdGeomPointBased, point3f[]; animated by timeSamples,
///                                       linear between them
///   widths                              UsdGeomCurves: diameters
///   primvars:displayColor               UsdGeomGprim, linear RGB; also of a prim above
///   primvars:displayOpacity             UsdGeomGprim, 1 - transparency; also of a prim above
///                                       these three: constant, uniform, varying or vertex, also
///                                       with indices; held from sample to sample
///   xformOpOrder, xformOp:...           UsdGeomXformable, of the curves and above (usda_transform)
///   visibility, active                  invisible or inactive curves are left out
///   extent                              UsdGeomBoundable: corners of all points, with half the
///                                       largest width around them; written, animated with the
///                                       points
///   metersPerUnit, upAxis               UsdGeom stage metrics; fallbacks 0.01 and "Y". "Z" is read
///                                       as +Z up, -Y face
///   startTimeCode, endTimeCode,         UsdStage
///   timeCodesPerSecond, framesPerSecond

/// Locates what a file's BasisCurves consist of in one pass; then reads any frame. All of them are
/// joined, in the order of the file. Memory: an offset a sample, and one block of the file. Throws
/// Error (file, line, cause): binary files (.usdc) are refused.
class UsdaReader {
 public:
  /// `stream` must outlive the reader; `name` names the file in messages. `prim`: a path or a name,
  /// of curves or of a prim above them; empty: all curves.
  UsdaReader(std::istream& stream, std::string_view name, std::string_view prim = {});
  UsdaReader(const UsdaReader&) = delete;
  UsdaReader& operator=(const UsdaReader&) = delete;

  /// Times at which points or transforms have samples; 1 where nothing is animated.
  std::size_t frameCount() const;
  /// Of a frame, seconds from startTimeCode.
  double seconds(std::size_t frame) const;
  /// Of a frame; 0 where nothing is animated.
  double timeCode(std::size_t frame) const;
  /// 0 where nothing is animated.
  double codesPerSecond() const;
  /// In the file's units; `scale` and `up` are what the file states.
  void read(std::size_t frame, StrandFile& out);

 private:
  using Attribute = UsdaLayer::Attribute;

  // A primvar, and the attribute of its indices, if it has some.
  struct Primvar {
    const Attribute* values = nullptr;
    const Attribute* indices = nullptr;
  };
  struct Curves {
    std::size_t prim;
    std::string path;
    UsdaCurveKind kind;
    const Attribute *counts, *points;
    Primvar widths, colours, opacity;
  };
  // The curves of a prim in a frame, and where their strands come from.
  struct Shape {
    std::vector<std::uint32_t> first = {0}, firstVarying = {0};  // of the file's vertices
    std::vector<UsdaCurvePoint> points;  // of all strands; empty: the vertices themselves
    std::vector<std::uint32_t> curveOf;  // of points
  };

  void findCurves(std::string_view wanted);
  void addCurves(std::size_t prim);
  bool isHidden(std::size_t prim) const;
  Primvar primvarOf(std::size_t prim, std::string_view name) const;
  void readCurves(const Curves& curves, double time, StrandFile& out);
  void readPoints(const Curves& curves, double time, std::vector<glm::vec3>& points);
  Shape shapeOf(const Curves& curves, const StrandSet& vertices) const;
  void goTo(const Attribute& attribute, double time);
  glm::vec3 vec3(std::string_view what);
  template <class Item>
  void readArray(std::string_view what, Item&& item);
  template <class T, class Item>
  void readPrimvar(const Primvar& primvar, std::string_view what, double time, const Shape& shape,
                   std::vector<T>& items, T& constant, Item&& item);

  UsdaScanner in_;
  UsdaLayer layer_;
  std::vector<Curves> curves_;
  std::vector<double> times_;  // of frames; empty: nothing is animated
  StrandFile part_;            // used again by every prim and frame
};

/// One frame: readStrands takes the first.
StrandFile readUsda(const std::filesystem::path& file, const ReadOptions& options);

}  // namespace hair
