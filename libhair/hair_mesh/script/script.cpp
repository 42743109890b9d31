#include <libhair/hair_mesh/script/script.h>

#include <libhair/core/error.h>
#include <libhair/files/byte_reader.h>
#include <libhair/hair_mesh/script/workshop.h>

namespace hair {

namespace {

void applyLine(const HairMeshScript& script, const HairMeshScript::Line& line, Workshop& w) {
  try {
    require(++w.lines <= w.limits.lines, "a script may have ", w.limits.lines, " operations");
    w.spend();
    line.apply(w);
  } catch (const Error& e) {
    throw Error(text(script.name, ": line ", line.number, ": ", e.what()));
  }
}

// include NAME: all lines of another script, as if they stood here
ScriptStep readInclude(ScriptWords& words) {
  return [file = std::string(words.word("a file"))](Workshop& w) {
    constexpr std::uint32_t kDeepest = 8;
    require(w.files != nullptr, "files are not read here: '", TextReader::shown(file), "'");
    require(w.included < kDeepest, "'", TextReader::shown(file), "': scripts may include others ",
            kDeepest, " deep; does it include itself?");
    const HairMeshScript script = parseHairMeshScript(w.files(file), file);
    ++w.included;
    for (const HairMeshScript::Line& line : script.lines) applyLine(script, line, w);
    --w.included;
  };
}

ScriptStep readLine(ScriptWords& words) {
  const std::string_view name = words.word("an operation");
  if (name == "include") return readInclude(words);
  for (const auto commands : {selectionCommands(), topologyCommands(), geometryCommands(),
                              growthCommands(), sweepCommands()})
    for (const ScriptCommand& command : commands)
      if (command.name == name) return command.read(words);
  words.fail("there is no operation '", TextReader::shown(name), "'");
}

}  // namespace

ScriptFiles filesBeside(const std::filesystem::path& script) {
  return [folder = script.parent_path()](const std::string& name) {
    return readWholeFile(folder / name);
  };
}

HairMeshScript parseHairMeshScript(std::string_view text, std::string_view name) {
  TextReader in(text, name);
  HairMeshScript script{std::string(name), {}};
  while (in.nextLine()) {
    ScriptWords words(in);
    if (words.done()) continue;
    script.lines.push_back({in.lineNumber(), readLine(words)});
    words.end();
  }
  return script;
}

HairMeshScript readHairMeshScript(const std::filesystem::path& file) {
  return parseHairMeshScript(readWholeFile(file), file.string());
}

ScriptRun::ScriptRun(ScriptFiles files, ScriptLimits limits)
    : workshop_(std::make_unique<Workshop>()) {
  workshop_->files = std::move(files);
  workshop_->limits = limits;
}
ScriptRun::~ScriptRun() = default;

void ScriptRun::apply(const HairMeshScript& script, std::size_t line) {
  Workshop changed = *workshop_;
  applyLine(script, script.lines.at(line), changed);
  *workshop_ = std::move(changed);
}

const Hairstyle& ScriptRun::style() const {
  return workshop_->style;
}

Hairstyle applyScript(const HairMeshScript& script, ScriptFiles files, ScriptLimits limits) {
  ScriptRun run(std::move(files), limits);
  for (std::size_t line = 0; line < script.lines.size(); ++line) run.apply(script, line);
  require(run.style().mesh.bundleCount() > 0, script.name,
          ": no scalp: a script begins with `scalp head RINGS SECTORS`");
  return run.style();
}

}  // namespace hair
