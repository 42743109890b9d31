#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <libhair/files/strand_file.h>
#include <libhair/files/usda/usda_scanner.h>

namespace hair {

/// What stands in a USD text file, as far as it matters to curves: prims, their transforms, and
/// where the values of attributes begin. Values are read later, from their places, so that memory
/// does not grow with them.
///
/// Of a variant set the chosen variant counts (metadata `variants`), else the first; what a prim
/// states itself is stronger. References, payloads and sublayers are not followed.
class UsdaLayer {
 public:
  struct Sample {
    double time;
    UsdaScanner::Place place;
  };
  struct Attribute {
    std::vector<Sample> samples;  ///< in the order of time; one at any time where not animated
    std::string interpolation;    ///< empty: not stated
    bool animated = false;
    bool weak = false;  ///< from a variant
  };
  struct Prim {
    std::string name, type;
    std::size_t parent = kNone;
    bool defined = false;  ///< by `def`; else it is a class, or an opinion about another layer
    bool active = true;
    std::map<std::string, Attribute, std::less<>> attributes;  ///< those that isOfUse
    std::map<std::string, std::string, std::less<>> tokens;    ///< type, basis, wrap, visibility
    std::vector<std::string> ops;                              ///< xformOpOrder
    bool weakOps = true;
    std::map<std::string, std::string, std::less<>> variants;  ///< the chosen one of a set

    const Attribute* find(std::string_view attribute) const {
      const auto at = attributes.find(attribute);
      return at == attributes.end() || at->second.samples.empty() ? nullptr : &at->second;
    }
    std::string_view token(std::string_view name_, std::string_view fallback) const {
      const auto at = tokens.find(name_);
      return at == tokens.end() ? fallback : std::string_view(at->second);
    }
  };
  static constexpr std::size_t kNone = ~std::size_t{0};

  /// Reads the whole file. Throws Error (file, line, cause).
  explicit UsdaLayer(UsdaScanner& in);

  std::vector<Prim> prims;  ///< parents before their children
  float metersPerUnit = 0.01f;
  UpAxis up = UpAxis::Y;
  double start = 0, codesPerSecond = 0, framesPerSecond = 0;  ///< a second; 0: not stated
  bool refersToOthers = false;                                ///< to other files, or by references
  std::vector<std::string> notes;

  /// "/World/Hair"
  std::string pathOf(std::size_t prim) const;

 private:
  // What a bracket `{` opened.
  struct Open {
    enum class Kind : std::uint8_t { Prim, VariantSet, Variant } kind;
    std::size_t prim;
    std::string set{};  // of variants
  };

  void readBlock();
  void readLayerMetadata();
  void beginPrim(const std::string& specifier);
  void readPrimMetadata(std::size_t prim);
  void readVariant(const std::string& name);
  void readProperty(const std::string& firstWord);
  void readValue(const std::string& name, Attribute* attribute);
  void readSamples(Attribute* attribute);
  template <class Take>
  void readMetadata(Take&& take);
  bool weak() const;
  Attribute* attributeToSet(const std::string& name);

  UsdaScanner& in_;
  std::vector<Open> open_;
  std::map<std::pair<std::size_t, std::string>, std::size_t>
      places_;  // of prims, by parent and name
};

}  // namespace hair
