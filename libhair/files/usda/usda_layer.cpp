#include <libhair/files/usda/usda_layer.h>

#include <algorithm>

namespace hair {

namespace {

using Token = UsdaScanner::Token;

constexpr std::string_view kSamples = ".timeSamples";
constexpr std::size_t kMostWords = 16;  // of a property: "custom uniform token[] name" has four
constexpr std::size_t kDeepest = 1000;  // prims and variants inside one another

bool isOfUse(std::string_view name) {
  constexpr std::string_view kNames[] = {"curveVertexCounts",
                                         "points",
                                         "widths",
                                         "primvars:widths",
                                         "primvars:widths:indices",
                                         "primvars:displayColor",
                                         "primvars:displayColor:indices",
                                         "primvars:displayOpacity",
                                         "primvars:displayOpacity:indices"};
  return name.starts_with("xformOp:") ||
         std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames);
}

bool isToken(std::string_view name) {
  return name == "type" || name == "basis" || name == "wrap" || name == "visibility";
}

}  // namespace

UsdaLayer::UsdaLayer(UsdaScanner& in) : in_(in) {
  if (in_.takeSign('(')) readLayerMetadata();
  readBlock();
  for (Prim& prim : prims)
    for (auto& [name, attribute] : prim.attributes) {
      std::vector<Sample>& samples = attribute.samples;
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

std::string UsdaLayer::pathOf(std::size_t prim) const {
  std::vector<std::size_t> chain;
  for (std::size_t p = prim; p != kNone; p = prims[p].parent) chain.push_back(p);
  std::string path;
  for (std::size_t i = chain.size(); i-- > 0;) path += '/' + prims[chain[i]].name;
  return path;
}

bool UsdaLayer::weak() const {
  return std::any_of(open_.begin(), open_.end(),
                     [](const Open& o) { return o.kind == Open::Kind::Variant; });
}

// All that follows the metadata of the layer.
void UsdaLayer::readBlock() {
  for (Token token = in_.next(); token.kind != Token::Kind::End; token = in_.next()) {
    if (token.isSign(';')) continue;
    if (token.isSign('}')) {
      in_.expect(!open_.empty(), "'}' closes nothing");
      open_.pop_back();
      continue;
    }
    if (!open_.empty() && open_.back().kind == Open::Kind::VariantSet) {
      in_.expect(token.kind == Token::Kind::String, "the name of a variant was expected");
      readVariant(token.text);
      continue;
    }
    in_.expect(token.kind == Token::Kind::Word, "'", TextReader::shown(token.text),
               "' was not expected");
    if (token.text == "def" || token.text == "over" || token.text == "class") {
      beginPrim(token.text);
    } else if (token.text == "variantSet") {
      const std::string name = in_.next().text;
      in_.expectSign('=', "variantSet");
      in_.expect(!open_.empty(), "a variantSet outside of a prim");
      in_.expectSign('{', "variantSet");
      open_.push_back({Open::Kind::VariantSet, open_.back().prim, name});
    } else {
      readProperty(token.text);
    }
    in_.expect(open_.size() <= kDeepest, "more than ", kDeepest, " prims inside one another");
  }
  in_.expect(open_.empty(), "the file ends within a prim (truncated)");
}

void UsdaLayer::readVariant(const std::string& name) {
  const std::size_t prim = open_.back().prim;
  const std::string set = open_.back().set;
  const auto [chosen, first] = prims[prim].variants.try_emplace(set, name);
  if (first)
    notes.push_back(text("no variant of ", TextReader::shown(set),
                         " is chosen: ", TextReader::shown(name), ", the first"));
  const bool mine = chosen->second == name;
  if (in_.takeSign('(')) {
    if (mine)
      readPrimMetadata(prim);
    else
      in_.skipBrackets();
  }
  in_.expectSign('{', "a variant");
  if (mine)
    open_.push_back({Open::Kind::Variant, prim});
  else
    in_.skipBrackets();
}

// From behind `(` to behind `)`; `take` says whether it read the value of a key itself.
template <class Take>
void UsdaLayer::readMetadata(Take&& take) {
  while (!in_.takeSign(')')) {
    Token key = in_.next();
    if (key.kind == Token::Kind::String || key.isSign(';') || key.isSign(',')) continue;
    in_.expect(key.kind == Token::Kind::Word, "a name was expected in ( )");
    while (in_.peek().kind == Token::Kind::Word) key = in_.next();  // "prepend references"
    in_.expectSign('=', TextReader::shown(key.text));
    if (!take(key.text)) in_.skipValue();
  }
}

void UsdaLayer::readLayerMetadata() {
  readMetadata([&](const std::string& key) {
    if (key == "metersPerUnit") {
      metersPerUnit = in_.number(key);
      in_.expect(metersPerUnit > 0, "metersPerUnit of ", metersPerUnit);
    } else if (key == "upAxis") {
      const Token axis = in_.next();
      in_.expect(axis.text == "Y" || axis.text == "Z", "upAxis '", TextReader::shown(axis.text),
                 "': USD has Y and Z");
      up = axis.text == "Y" ? UpAxis::Y : UpAxis::ZBack;
    } else if (key == "startTimeCode") {
      start = in_.real(key);
    } else if (key == "timeCodesPerSecond" || key == "framesPerSecond") {
      const double rate = in_.real(key);
      in_.expect(rate > 0, key, " of ", rate);
      (key == "framesPerSecond" ? framesPerSecond : codesPerSecond) = rate;
    } else {
      refersToOthers = refersToOthers || key == "subLayers";
      return false;
    }
    return true;
  });
}

void UsdaLayer::readPrimMetadata(std::size_t prim) {
  readMetadata([&](const std::string& key) {
    if (key == "active") {
      const Token value = in_.next();
      prims[prim].active = !value.isWord("false") && !value.isWord("0");
      return true;
    }
    if (key == "variants" && in_.takeSign('{')) {
      // string shape = "long"
      while (!in_.takeSign('}')) {
        Token word = in_.next();
        if (word.isSign(';') || word.isSign(',')) continue;
        in_.expect(word.kind == Token::Kind::Word, "variants: a name was expected");
        while (in_.peek().kind == Token::Kind::Word || in_.peek().kind == Token::Kind::String)
          word = in_.next();
        in_.expectSign('=', "variants");
        prims[prim].variants.try_emplace(word.text, in_.next().text);
      }
      return true;
    }
    refersToOthers = refersToOthers || key == "references" || key == "payload";
    return false;
  });
}

void UsdaLayer::beginPrim(const std::string& specifier) {
  std::string type;
  Token token = in_.next();
  if (token.kind == Token::Kind::Word) {
    type = token.text;
    token = in_.next();
  }
  in_.expect(token.kind == Token::Kind::String, "the name of a prim was expected");
  const std::size_t parent = open_.empty() ? kNone : open_.back().prim;
  const auto [at, isNew] = places_.try_emplace({parent, token.text}, prims.size());
  const std::size_t prim = at->second;
  if (isNew) {
    prims.emplace_back().name = token.text;
    prims.back().parent = parent;
  }
  if (prims[prim].type.empty() || specifier == "def") prims[prim].type = type;
  prims[prim].defined = prims[prim].defined || specifier == "def";
  if (in_.takeSign('(')) readPrimMetadata(prim);
  in_.expectSign('{', "a prim");
  open_.push_back({Open::Kind::Prim, prim});
}

// Null where it does not matter, or where a stronger opinion stands already.
UsdaLayer::Attribute* UsdaLayer::attributeToSet(const std::string& name) {
  if (open_.empty() || !isOfUse(name)) return nullptr;
  Attribute& attribute = prims[open_.back().prim].attributes[name];
  if (attribute.samples.empty()) attribute.weak = weak();
  if (attribute.weak && !weak()) attribute = {};
  return attribute.weak == weak() ? &attribute : nullptr;
}

// Such as: uniform token type = "linear", float[] widths (interpolation = "vertex")
void UsdaLayer::readProperty(const std::string& firstWord) {
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
  Attribute* attribute = attributeToSet(name);
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

void UsdaLayer::readValue(const std::string& name, Attribute* attribute) {
  if (attribute) {
    // Samples, where there are any, are what is meant.
    if (!attribute->animated && !in_.peek().isWord("None")) attribute->samples = {{0, in_.place()}};
  } else if (!open_.empty() && isToken(name) && in_.peek().kind == Token::Kind::String) {
    auto& tokens = prims[open_.back().prim].tokens;
    const std::string value = in_.next().text;
    if (weak())
      tokens.try_emplace(name, value);
    else
      tokens[name] = value;
    return;
  } else if (name == "xformOpOrder" && !open_.empty() && in_.takeSign('[')) {
    Prim& prim = prims[open_.back().prim];
    const bool taken = prim.weakOps || !weak();
    if (taken) prim.ops.clear();
    prim.weakOps = prim.weakOps && weak();
    while (!in_.takeSign(']')) {
      const Token op = in_.next();
      in_.expect(op.kind == Token::Kind::String, "xformOpOrder: the name of a transform expected");
      if (taken) prim.ops.push_back(op.text);
      if (in_.takeSign(',')) continue;
      in_.expectSign(']', "xformOpOrder");
      break;
    }
    return;
  }
  in_.skipValue();
}

void UsdaLayer::readSamples(Attribute* attribute) {
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

}  // namespace hair
