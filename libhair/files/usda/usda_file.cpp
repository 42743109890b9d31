#include <libhair/files/usda/usda_file.h>

#include <algorithm>

#include <libhair/files/byte_reader.h>

namespace hair {

namespace {

using Token = UsdaScanner::Token;

constexpr std::string_view kSamples = ".timeSamples";
constexpr std::size_t kMostWords = 16;  // of a property: "custom uniform token[] name" has four

}  // namespace

UsdaReader::UsdaReader(std::istream& stream, std::string_view name) : in_(stream, name) {
  char magic[8] = {};
  stream.read(magic, sizeof magic);
  const std::string_view start(magic, static_cast<std::size_t>(stream.gcount()));
  in_.expect(!start.starts_with("PXR-USDC"),
             "this is a binary USD file; turn it into text (usdcat -o out.usda) first");
  in_.expect(!start.starts_with("PK"), "this is a packed USD file (.usdz); unpack it first");
  in_.expect(start.starts_with("#usda "), "'#usda 1.0' expected: this is no USD text file");
  stream.clear();
  stream.seekg(0);
  readLayer();
  checkCurves();
}

void UsdaReader::readLayer() {
  if (in_.takeSign('(')) readLayerMetadata();
  for (Token token = in_.next(); token.kind != Token::Kind::End; token = in_.next()) {
    if (token.isSign(';')) continue;
    if (token.isSign('}')) {
      in_.expect(!prims_.empty(), "'}' closes nothing");
      endPrim();
      continue;
    }
    in_.expect(token.kind == Token::Kind::Word, "'", TextReader::shown(token.text),
               "' was not expected");
    if (token.text == "def" || token.text == "over" || token.text == "class") {
      beginPrim(token.text);
    } else if (token.text == "variantSet") {
      in_.next();
      in_.expectSign('=', "variantSet");
      in_.skipValue();
    } else {
      readProperty(token.text);
    }
  }
  in_.expect(prims_.empty(), "the file ends within a prim (truncated)");
}

// From behind `(` to behind `)`; `take` says whether it read the value of a key itself.
template <class Take>
void UsdaReader::readMetadata(Take&& take) {
  while (!in_.takeSign(')')) {
    Token key = in_.next();
    if (key.kind == Token::Kind::String || key.isSign(';') || key.isSign(',')) continue;
    in_.expect(key.kind == Token::Kind::Word, "a name was expected in ( )");
    while (in_.peek().kind == Token::Kind::Word) key = in_.next();  // "prepend references"
    in_.expectSign('=', TextReader::shown(key.text));
    if (!take(key.text)) in_.skipValue();
  }
}

void UsdaReader::readLayerMetadata() {
  readMetadata([&](const std::string& key) {
    if (key == "metersPerUnit") {
      metersPerUnit_ = in_.number(key);
      in_.expect(metersPerUnit_ > 0, "metersPerUnit of ", metersPerUnit_);
    } else if (key == "upAxis") {
      const Token axis = in_.next();
      in_.expect(axis.text == "Y" || axis.text == "Z", "upAxis '", TextReader::shown(axis.text),
                 "': USD has Y and Z");
      up_ = axis.text == "Y" ? UpAxis::Y : UpAxis::ZBack;
    } else if (key == "startTimeCode") {
      start_ = in_.real(key);
    } else if (key == "timeCodesPerSecond" || key == "framesPerSecond") {
      const double rate = in_.real(key);
      in_.expect(rate > 0, key, " of ", rate);
      (key == "framesPerSecond" ? statedFrames_ : statedCodes_) = rate;
    } else {
      return false;
    }
    return true;
  });
}

void UsdaReader::beginPrim(const std::string& specifier) {
  Prim prim;
  Token token = in_.next();
  if (token.kind == Token::Kind::Word) {
    prim.curves = token.text == "BasisCurves" && specifier == "def";
    token = in_.next();
  }
  in_.expect(token.kind == Token::Kind::String, "the name of a prim was expected");
  prim.name = token.text;
  if (in_.takeSign('(')) readMetadata([](const std::string&) { return false; });
  in_.expectSign('{', "a prim");
  prims_.push_back(std::move(prim));
  if (!prims_.back().curves) return;
  in_.expect(curvesName_.empty(), "a second BasisCurves, ", TextReader::shown(token.text),
             ", after ", TextReader::shown(curvesName_), ": one is read; leave one in the file");
  curvesName_ = token.text.empty() ? "?" : token.text;
  for (Prim& p : prims_) p.holdsCurves = true;
}

void UsdaReader::endPrim() {
  const Prim& prim = prims_.back();
  in_.expect(!prim.transformed || !prim.holdsCurves, "the strands stand in the transform of ",
             TextReader::shown(prim.name), ": apply it first, transforms are not read");
  prims_.pop_back();
}

UsdaReader::Attribute* UsdaReader::attributeOf(const std::string& name) {
  if (prims_.empty() || !prims_.back().curves) return nullptr;
  if (name == "curveVertexCounts") return &counts_;
  if (name == "points") return &points_;
  if (name == "widths" || name == "primvars:widths") return &widths_;
  if (name == "primvars:displayColor") return &colours_;
  if (name == "primvars:displayOpacity") return &opacity_;
  return nullptr;
}

// Such as: uniform token type = "linear", float[] widths (interpolation = "vertex")
void UsdaReader::readProperty(const std::string& firstWord) {
  std::string name = firstWord;
  std::size_t words = 1;
  for (;; ++words) {
    if (in_.peek().isSign('[')) {
      in_.next();
      in_.expectSign(']', "a property");
    }
    if (in_.peek().kind != Token::Kind::Word || in_.peek().firstOfLine) break;
    in_.expect(words < kMostWords, "a property of more than ", kMostWords, " words");
    name = in_.next().text;
  }
  in_.expect(words >= 2, "'", TextReader::shown(firstWord), "' was not expected");
  const bool sampled = name.ends_with(kSamples);
  if (sampled) name.resize(name.size() - kSamples.size());
  Attribute* attribute = attributeOf(name);
  if (in_.takeSign('=')) {
    if (sampled)
      readSamples(attribute);
    else
      readValue(name, attribute);
  }
  if (!in_.takeSign('(')) return;
  readMetadata([&](const std::string& key) {
    if (!attribute || key != "interpolation") return false;
    attribute->interpolation = in_.next().text;
    return true;
  });
}

void UsdaReader::readValue(const std::string& name, Attribute* attribute) {
  const bool curves = !prims_.empty() && prims_.back().curves;
  if (attribute) {
    // Samples, where there are any, are what is meant.
    if (!attribute->animated && !in_.peek().isWord("None")) attribute->samples = {{0, in_.place()}};
  } else if (curves && (name == "type" || name == "wrap")) {
    (name == "type" ? type_ : wrap_) = in_.next().text;
    return;
  } else if (name == "xformOpOrder" && !prims_.empty() && in_.takeSign('[')) {
    prims_.back().transformed = !in_.takeSign(']');
    if (prims_.back().transformed) in_.skipBrackets();
    return;
  } else if (curves &&
             (name == "primvars:displayColor:indices" ||
              name == "primvars:displayOpacity:indices" || name == "primvars:widths:indices")) {
    in_.fail(name, ": indexed values are not read; write one a point");
  }
  in_.skipValue();
}

void UsdaReader::readSamples(Attribute* attribute) {
  in_.expectSign('{', "timeSamples");
  if (attribute && !attribute->animated) {
    attribute->samples.clear();
    attribute->animated = true;
  }
  while (!in_.takeSign('}')) {
    const double time = in_.real("time of a sample");
    in_.expect(in_.takeSign(':'), "':' is missing behind the time of a sample");
    if (attribute && !in_.peek().isWord("None")) attribute->samples.push_back({time, in_.place()});
    in_.skipValue();
    if (in_.takeSign(',')) continue;
    in_.expectSign('}', "timeSamples");
    break;
  }
}

void UsdaReader::checkCurves() {
  in_.expect(!curvesName_.empty(), "the file ends without a BasisCurves prim");
  const std::string shown = TextReader::shown(curvesName_);
  in_.expect(type_ == "linear", "BasisCurves ", shown, " is of type '", TextReader::shown(type_),
             "'; only linear curves are read: have the program that wrote it resample them");
  in_.expect(wrap_ == "nonperiodic" || wrap_ == "pinned", "BasisCurves ", shown, " has the wrap '",
             TextReader::shown(wrap_), "'; strands have a root and a tip");
  in_.expect(!counts_.samples.empty(), "BasisCurves ", shown, " has no curveVertexCounts");
  in_.expect(!points_.samples.empty(), "BasisCurves ", shown, " has no points");
  for (Attribute* a : {&counts_, &points_, &widths_, &colours_, &opacity_}) {
    std::vector<Sample>& samples = a->samples;
    std::stable_sort(samples.begin(), samples.end(),
                     [](const Sample& x, const Sample& y) { return x.time < y.time; });
    // Of two samples of one time the later counts, as in a dictionary.
    std::size_t kept = 0;
    for (const Sample& sample : samples) {
      if (kept > 0 && samples[kept - 1].time == sample.time) --kept;
      samples[kept++] = sample;
    }
    samples.erase(samples.begin() + static_cast<std::ptrdiff_t>(kept), samples.end());
  }
}

std::size_t UsdaReader::frameCount() const {
  return points_.samples.size();
}

double UsdaReader::timeCode(std::size_t frame) const {
  return points_.animated ? points_.samples[frame].time : 0;
}

double UsdaReader::codesPerSecond() const {
  if (!points_.animated) return 0;
  if (statedCodes_ > 0) return statedCodes_;
  return statedFrames_ > 0 ? statedFrames_ : 24;  // USD's fallback
}

double UsdaReader::seconds(std::size_t frame) const {
  return points_.animated ? (timeCode(frame) - start_) / codesPerSecond() : 0;
}

// To the last sample up to that time, or else the first.
bool UsdaReader::goToSample(const Attribute& attribute, double time) {
  if (attribute.samples.empty()) return false;
  auto after = std::upper_bound(attribute.samples.begin(), attribute.samples.end(), time,
                                [](double t, const Sample& s) { return t < s.time; });
  if (after != attribute.samples.begin()) --after;
  in_.goTo(after->place);
  return true;
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

// One value a point, of however many the file has; or the one for all.
template <class T>
void UsdaReader::spread(const Attribute& attribute, std::string_view what, const StrandSet& strands,
                        std::vector<T>& items, T& constant) {
  if (items.empty()) return;
  const std::string& stated = attribute.interpolation;
  const std::size_t count = items.size();
  if (count == 1 && (stated.empty() || stated == "constant")) {
    constant = items[0];
    items.clear();
  } else if (stated == "uniform") {
    in_.expect(count == strands.strandCount(), what, ": ", count, " values for ",
               strands.strandCount(), " curves");
    const std::vector<T> each = std::move(items);
    items.clear();
    for (std::size_t s = 0; s < each.size(); ++s) items.resize(strands.first[s + 1], each[s]);
  } else {
    in_.expect(stated.empty() || stated == "vertex" || stated == "varying", what,
               ": interpolation '", TextReader::shown(stated), "' does not fit ", count, " values");
    in_.expect(count == strands.pointCount(), what, ": ", count, " values for ",
               strands.pointCount(), " points");
  }
}

void UsdaReader::read(std::size_t frame, StrandFile& out) {
  require(frame < frameCount(), "frame ", frame, " of ", frameCount());
  const double time = points_.samples[frame].time;
  const auto vec3 = [&](std::string_view what) {
    glm::vec3 v;
    in_.expect(in_.takeSign('('), what, ": '(' expected");
    for (int c = 0; c < 3; ++c) {
      in_.expect(c == 0 || in_.takeSign(','), what, ": three numbers expected");
      v[c] = in_.number(what);
    }
    in_.expect(in_.takeSign(')'), what, ": ')' expected");
    return v;
  };

  StrandSet& strands = out.strands;
  strands.first.assign(1, 0);
  strands.points.clear();
  goToSample(counts_, time);
  readArray("curveVertexCounts", [&] {
    const long long count = in_.integer("curveVertexCounts");
    in_.expect(count >= 0 && count <= 0xffffffffll - strands.first.back(), "curve ",
               strands.strandCount(), " has ", count, " points");
    strands.first.push_back(strands.first.back() + static_cast<std::uint32_t>(count));
  });
  goToSample(points_, time);
  readArray("points", [&] { strands.points.push_back(vec3("points")); });
  in_.expect(strands.pointCount() == strands.first.back(), "curveVertexCounts ask for ",
             strands.first.back(), " points, there are ", strands.pointCount());
  in_.expect(strands.strandCount() > 0, "the file holds no strands");

  out.format = "usda";
  out.arrays = "points";
  out.scale = metersPerUnit_;
  out.up = up_;
  out.thickness.clear();
  out.transparency.clear();
  out.colours.clear();
  out.defaultThickness = out.defaultTransparency = 0;
  out.defaultColour = glm::vec3(0);
  if (goToSample(widths_, time))
    readArray("widths", [&] { out.thickness.push_back(in_.number("widths")); });
  spread(widths_, "widths", strands, out.thickness, out.defaultThickness);
  if (goToSample(colours_, time))
    readArray("displayColor", [&] { out.colours.push_back(vec3("displayColor")); });
  spread(colours_, "displayColor", strands, out.colours, out.defaultColour);
  if (goToSample(opacity_, time))
    readArray("displayOpacity",
              [&] { out.transparency.push_back(1 - in_.number("displayOpacity")); });
  spread(opacity_, "displayOpacity", strands, out.transparency, out.defaultTransparency);
}

StrandFile readUsda(const std::filesystem::path& file) {
  std::ifstream stream = openFile(file);
  UsdaReader reader(stream, file.string());
  StrandFile strands;
  reader.read(0, strands);
  return strands;
}

}  // namespace hair
