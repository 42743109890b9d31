#include <apps/common/command_line.h>

#include <exception>
#include <iostream>
#include <map>

#include <libhair/core/error.h>

namespace hair {

namespace {

glm::vec3 vectorFromText(const std::string& name, const std::string& words) {
  std::istringstream in(words);
  char comma1 = 0, comma2 = 0;
  glm::vec3 v;
  if (!(in >> v.x >> comma1 >> v.y >> comma2 >> v.z) || comma1 != ',' || comma2 != ',' ||
      !(in >> std::ws).eof())
    throw CLI::ValidationError(name, "wants X,Y,Z, three numbers; got " + words);
  return v;
}

// X,Y,Z as one word, so that a negative first number is no option.
void addVector(CLI::App& command, const std::string& name, glm::vec3& value,
               const std::string& help) {
  command
      .add_option_function<std::string>(
          name, [&value, name](const std::string& words) { value = vectorFromText(name, words); },
          help)
      ->type_name("X,Y,Z");
}

}  // namespace

void addVectors(CLI::App& command, const std::string& name, std::vector<glm::vec3>& values,
                const std::string& help) {
  command
      .add_option_function<std::vector<std::string>>(
          name,
          [&values, name](const std::vector<std::string>& all) {
            values.clear();
            for (const std::string& words : all) values.push_back(vectorFromText(name, words));
          },
          help)
      ->expected(1)
      ->take_all()
      ->type_name("X,Y,Z");
}

void addReadOptions(CLI::App& command, ReadOptions& read) {
  command
      .add_option("--scale", read.scale,
                  "metres per unit of the file; default: .hair 0.00465, others 1")
      ->check(within(1e-9, 1e9));
  command
      .add_option_function<std::string>(
          "--up",
          [&read](const std::string& text) {
            try {
              read.up = upAxisFromText(text);
            } catch (const Error& e) {
              throw CLI::ValidationError("--up", e.what());
            }
          },
          "axis of the file that points up: y (face +z), z (face +y), z-back (face -y: Blender), "
          "x, y-down; default: .hair z, others y")
      ->type_name("AXIS");
}

void addHairOptions(CLI::App& command, SubjectOptions& subject) {
  static const std::map<std::string, Style> styles = {
      {"smooth", Style::Smooth}, {"curly", Style::Curly}, {"long", Style::Long}};
  auto* style = command
                    .add_option("--style", subject.style,
                                "built-in hairstyle: smooth, curly or long; default smooth")
                    ->transform(CLI::CheckedTransformer(styles, CLI::ignore_case))
                    ->type_name("STYLE");
  command.add_option("--hair", subject.hair, "hair of a file instead: .hair, .tfx or .data")
      ->excludes(style);
  command
      .add_option("--strands", subject.strands,
                  "drawn strands; default: the style's, or all of the file's")
      ->check(CLI::Range(1, 10'000'000));
  command
      .add_option("--points", subject.points,
                  "points of a drawn strand; default: the style's, or the file's")
      ->check(CLI::Range(2, 4096));
  addReadOptions(command, subject.read);
}

void addSubjectOptions(CLI::App& command, SubjectOptions& subject) {
  addHairOptions(command, subject);
  command
      .add_option(
          "--head", subject.heads,
          "the head of that hair, .obj in the same coordinates; again for eyes and the like")
      ->expected(1)
      ->take_all()
      ->type_name("FILE");
  command.add_option("--motion", subject.motion,
                     "motion capture, .bvh; default: the built-in dance");
  command
      .add_option("--motion-scale", subject.motionScale,
                  "metres per unit of the clip; default 0.01")
      ->check(within(1e-9, 1e9));
  command.add_flag("--still", subject.still, "nobody moves");
  command
      .add_option("--guides", subject.guides, "simulated strands of a loaded groom; default 402")
      ->check(CLI::Range(1, 1'000'000));
}

void addPerformanceOptions(CLI::App& command, PerformanceOptions& performance, int& threads) {
  command.add_option("--fps", performance.fps, "frames a second of the motion; default 60")
      ->check(within(1.0, 1000.0));
  command.add_option("--threads", threads, "0, the default: as many as the machine has")
      ->check(CLI::Range(0, 1024));
  command
      .add_option("--cells", performance.cells, "of the shadow map along each axis; default 128")
      ->check(CLI::Range(2, 1024));
  addVector(command, "--light", performance.light,
            "the way the light travels; default 0.45,-0.8,-0.4");
  addVector(command, "--wind", performance.wind, "m/s; default still air");
  command.add_flag("!--no-shadow", performance.shadow, "leave self-shadowing out");
  command.add_flag("!--no-self-collision", performance.selfCollision,
                   "leave hair-hair repulsion out");
  command
      .add_option("--settle", performance.settle, "seconds to settle in the first pose; default 1")
      ->check(within(0.0, 60.0));
}

void addResultOptions(CLI::App& command, ResultFiles& results) {
  command.add_option("--profile", results.profile, "times by stage, CSV")->check(endsWith(".csv"));
  command
      .add_option("--stats", results.stats,
                  "stretch, penetration, energy and speed of every frame, CSV")
      ->check(endsWith(".csv"));
  command.add_flag("--hash", results.hash, "last line: `hash` and 16 digits over the state's bits");
}

int runReporting(const char* program, const std::function<int()>& body) {
  try {
    return body();
  } catch (const std::bad_alloc&) {
    std::cerr << program << ": out of memory; take fewer strands, points or cells\n";
  } catch (const std::exception& e) {
    std::cerr << program << ": " << e.what() << '\n';
  }
  return 1;
}

}  // namespace hair
