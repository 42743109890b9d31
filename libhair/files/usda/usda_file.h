#pragma once

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include <libhair/files/strand_file.h>
#include <libhair/files/usda/usda_scanner.h>

namespace hair {

/// Strands in USD's text format, as a prim of the schema UsdGeomBasisCurves
/// (openusd.org/release/api/class_usd_geom_basis_curves.html and the pages named here):
///
///   type "linear", wrap "nonperiodic"   BasisCurves: straight between vertices, not closed; the
///                                       schema's fallback for `type` is "cubic", so it is written
///   curveVertexCounts                   UsdGeomCurves: vertices of each curve, at least 2
///   points                              UsdGeomPointBased, point3f[]; animated by timeSamples
///   widths                              UsdGeomCurves: diameters; interpolation vertex or constant
///   primvars:displayColor               UsdGeomGprim, linear RGB; vertex or constant
///   primvars:displayOpacity             UsdGeomGprim, 1 - transparency; vertex or constant
///   extent                              UsdGeomBoundable: corners of all points, with half the
///                                       largest width around them; animated with the points
///   metersPerUnit, upAxis               UsdGeom stage metrics; fallbacks 0.01 and "Y". "Z" is read
///                                       as +Z up, -Y face
///   startTimeCode, endTimeCode,         UsdStage
///   timeCodesPerSecond, framesPerSecond

/// Locates the attributes of a file's BasisCurves prim in one pass; then reads any frame. Memory:
/// an offset a frame, and one block of the file. Skips other prims, relationships, dictionaries,
/// variants and references. Throws Error (file,
/// line, cause): binary files (.usdc), cubic or periodic curves, transforms, indexed primvars and a
/// second BasisCurves are refused.
class UsdaReader {
 public:
  /// `stream` must outlive the reader; `name` names the file in messages.
  UsdaReader(std::istream& stream, std::string_view name);

  /// Samples of points; 1 where they are not animated.
  std::size_t frameCount() const;
  /// Of a frame, seconds from startTimeCode.
  double seconds(std::size_t frame) const;
  /// Of a frame; 0 where points are not animated.
  double timeCode(std::size_t frame) const;
  /// 0 where points are not animated.
  double codesPerSecond() const;
  /// In the file's units; `scale` and `up` are what the file states. Other animated arrays are held
  /// from sample to sample.
  void read(std::size_t frame, StrandFile& out);

 private:
  struct Sample {
    double time;
    UsdaScanner::Place place;
  };
  struct Attribute {
    std::vector<Sample> samples;  // in the order of time; one at any time where not animated
    std::string interpolation;    // empty: not stated
    bool animated = false;
  };
  struct Prim {
    std::string name;
    bool curves = false, holdsCurves = false, transformed = false;
  };

  void readLayer();
  void readLayerMetadata();
  void beginPrim(const std::string& specifier);
  void endPrim();
  void readProperty(const std::string& firstWord);
  void readValue(const std::string& name, Attribute* attribute);
  void readSamples(Attribute* attribute);
  template <class Take>
  void readMetadata(Take&& take);
  Attribute* attributeOf(const std::string& name);
  void checkCurves();
  bool goToSample(const Attribute& attribute, double time);
  template <class Item>
  void readArray(std::string_view what, Item&& item);
  template <class T>
  void spread(const Attribute& attribute, std::string_view what, const StrandSet& strands,
              std::vector<T>& items, T& constant);

  UsdaScanner in_;
  std::vector<Prim> prims_;  // that are open
  Attribute counts_, points_, widths_, colours_, opacity_;
  std::string type_ = "cubic", wrap_ = "nonperiodic";  // the schema's fallbacks
  std::string curvesName_;                             // empty: none so far
  float metersPerUnit_ = 0.01f;
  UpAxis up_ = UpAxis::Y;
  double start_ = 0, statedCodes_ = 0, statedFrames_ = 0;  // a second; 0: not stated
};

/// One frame: readStrands takes the first.
StrandFile readUsda(const std::filesystem::path& file);

}  // namespace hair
