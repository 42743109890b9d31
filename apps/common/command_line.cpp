#include <apps/common/command_line.h>

#include <exception>
#include <iostream>

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

// X,Y,Z or X,Y,Z,R,G,B, again and again: the lights stand in the order of the command line,
// whichever of the two options they come from.
void addLights(CLI::App& command, const std::string& name, Light::Kind kind,
               std::vector<Light>& lights, const std::string& help) {
  command
      .add_option_function<std::string>(
          name,
          [&lights, name, kind](const std::string& words) {
            std::istringstream in(words);
            float v[6] = {0, 0, 0, 1, 1, 1};
            int count = 0;
            for (char comma = ','; count < 6 && comma == ',' && in >> v[count]; ++count)
              if (!(in >> comma)) comma = 0;
            if (!in.eof() || words.ends_with(',') || (count != 3 && count != 6))
              throw CLI::ValidationError(
                  name, "wants X,Y,Z or X,Y,Z,R,G,B, three or six numbers; got " + words);
            const glm::vec3 where(v[0], v[1], v[2]), colour(v[3], v[4], v[5]);
            if (!glm::all(glm::greaterThanEqual(colour, glm::vec3(0))))
              throw CLI::ValidationError(name, "wants a colour that is not negative; got " + words);
            lights.push_back(kind == Light::Kind::Point ? Light::point(where, colour)
                                                        : Light::parallel(where, colour));
          },
          help)
      ->trigger_on_parse()
      ->type_name("X,Y,Z[,R,G,B]");
}

// Takes the word of a choice in any case, or refuses it with all words.
template <HasWords E>
CLI::Validator wordIn() {
  std::vector<std::pair<std::string, E>> words;
  for (const auto& word : wordsOf(E{})) words.emplace_back(word.word, word.value);
  return CLI::CheckedTransformer(words, CLI::ignore_case).description("");
}

// Checks a number against the range of a setting.
auto inside(const Range& range) {
  return [range](const std::string& word) -> std::string {
    return range.holds(std::strtod(word.c_str(), nullptr))
               ? ""
               : text(word, " is not in ", range.text());
  };
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

void addUpOption(CLI::App& command, const std::string& name, UpAxis& up, const std::string& help) {
  command
      .add_option_function<std::string>(
          name,
          [&up, name](const std::string& text) {
            try {
              up = upAxisFromText(text);
            } catch (const Error& e) {
              throw CLI::ValidationError(name, e.what());
            }
          },
          help)
      ->type_name("AXIS");
}

void addMotionReadOptions(CLI::App& command, MotionSettings& clip) {
  command
      .add_option("--motion-scale", clip.scale,
                  "metres per unit of the clip; default: what makes a person of it")
      ->check(within(1e-9, 1e9));
  command
      .add_option_function<std::string>(
          "--motion-up",
          [&clip](const std::string& text) {
            try {
              clip.up = clipUpFromText(text);
            } catch (const Error& e) {
              throw CLI::ValidationError("--motion-up", e.what());
            }
          },
          "axis of the clip that points up: y, z, x, y-down, z-down or x-down; default: along "
          "which "
          "the body stands")
      ->type_name("AXIS");
  command
      .add_option("--head-joint", clip.headJoint,
                  "joint of the clip that the head turns on; default: by its name or place")
      ->type_name("NAME");
}

void addReadOptions(CLI::App& command, ReadOptions& read) {
  command
      .add_option(
          "--scale", read.scale,
          "metres per unit of the file; default: what it states, or .hair 0.00465, others 1")
      ->check(within(1e-9, 1e9));
  addUpOption(command, "--up", read.up,
              "axis of the file that points up: y (face +z), z (face +y), z-back (face -y: "
              "Blender), x, y-down; default: what it states, or .hair z, others y");
  command.add_option("--prim", read.prim,
                     "of several curves in a .usda, those of this path or name; default: all");
  command
      .add_option("--points-per-strand", read.pointsPerStrand,
                  "of a cloud of points without edges; default: as their spacing shows")
      ->check(CLI::Range(2, 65536));
}

void addHairOptions(CLI::App& command, CharacterOptions& character) {
  auto* style = command
                    .add_option("--style", character.style,
                                "built-in hairstyle: smooth, curly or long; default smooth")
                    ->transform(wordIn<Style>())
                    ->type_name("STYLE");
  command
      .add_option("--hair", character.hair,
                  "hair of a file instead: .hair, .tfx, .data, .ply, .usda, .npy, .npz or .pbrt; "
                  "or a hair mesh: "
                  ".hairmesh or .obj")
      ->excludes(style);
  command
      .add_option("--strands", character.strands,
                  "drawn strands; default: the style's, or all of the file's")
      ->check(CLI::Range(1, 10'000'000));
  command
      .add_option("--points", character.points,
                  "points of a drawn strand; default: the style's, or the file's")
      ->check(CLI::Range(2, 4096));
  addReadOptions(command, character.read);
}

void addCharacterOptions(CLI::App& command, CharacterOptions& character) {
  addHairOptions(command, character);
  command
      .add_option(
          "--head", character.heads,
          "head mesh of the hair file, .obj in the same coordinates; repeat it for eyes and so on")
      ->expected(1)
      ->take_all()
      ->type_name("FILE");
  command
      .add_option("--head-scale", character.headRead.scale,
                  "metres per unit of the head files; default: as the hair's, or 1 where that fits")
      ->check(within(1e-9, 1e9));
  addUpOption(
      command, "--head-up", character.headRead.up,
      "axis of the head files that points up; default: as the hair's, or y where that fits");
  command.add_option("--motion", character.motion,
                     "motion capture, .bvh; default: the built-in dance");
  addMotionReadOptions(command, character.clip);
  command.add_flag("--verbose", character.verbose, "list each repair of the motion");
  command.add_flag("--still", character.still, "no motion: the body stands still");
  command
      .add_option("--guides", character.guides, "simulated strands of a loaded groom; default 402")
      ->check(CLI::Range(1, 1'000'000));
}

void addPlayerOptions(CLI::App& command, PlayerOptions& player, int& threads) {
  command.add_option("--fps", player.fps, "frames a second of the motion; default 60")
      ->check(within(1.0, 1000.0));
  command
      .add_option("--motion-speed", player.motionSpeed,
                  "speed of the body, as a factor; the hair has to follow; default 1")
      ->check(within(0.01, 100.0));
  command.add_option("--threads", threads, "0, the default: as many as the machine has")
      ->check(CLI::Range(0, 1024));
  command.add_option("--cells", player.cells, "of the shadow map along each axis; default 128")
      ->check(inside(rangeOf(&DensityGridSettings::cells)));
  addLights(command, "--light", Light::Kind::Parallel, player.lights,
            "direction in which parallel light travels, and its colour (linear; default 1,1,1); "
            "repeat it for more lights; default 0.45,-0.8,-0.4");
  addLights(command, "--point", Light::Kind::Point, player.lights,
            "position of a point light, metres, and its colour as it arrives at the head (brighter "
            "nearer by); repeat it for more lights");
  addVector(command, "--wind", player.wind, "its velocity, m/s; default still air");
  command.add_flag_callback(
      "--no-shadow", [&player] { player.shadow = false; }, "without self-shadowing");
  command.add_flag_callback(
      "--no-self-collision", [&player] { player.selfCollision = false; },
      "without self-collision: hair does not push hair");
  command
      .add_option("--solver", player.linkSolver,
                  "of the guides' links: direct (default) or relaxation, which stretches")
      ->transform(wordIn<LinkSolver>())
      ->type_name("SOLVER");
  command
      .add_option("--solver-iterations", player.linkIterations,
                  "of the solver a substep; default 2; relaxation wants 8 or more")
      ->check(inside(rangeOf(&GuideSettings::iterations)));
  command.add_option("--settle", player.settle, "seconds to settle in the first pose; default 1")
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

std::optional<int> exitCodeOfParsing(CLI::App& app, int argc, const char* const* argv,
                                     std::ostream& out, std::ostream& err) {
  app.failure_message([](const CLI::App* failed, const CLI::Error& e) {
    std::string program = failed->get_name();
    for (auto below = failed->get_subcommands(); !below.empty();
         below = below.front()->get_subcommands())
      program += ' ' + below.front()->get_name();
    return oneLine(text(program, ": ", e.what(), "; ", program, " --help tells more")) + '\n';
  });
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e, out, err) == 0 ? 0 : 2;
  }
  return std::nullopt;
}

std::string oneLine(std::string message) {
  for (char& c : message)
    if (static_cast<unsigned char>(c) < 32 || c == 127) c = '?';
  return message;
}

int runReporting(const char* program, const std::function<int()>& body) {
  try {
    return body();
  } catch (const std::bad_alloc&) {
    std::cerr << program << ": out of memory; take fewer strands, points or cells\n";
  } catch (const std::exception& e) {
    std::cerr << program << ": " << oneLine(e.what()) << '\n';
  }
  return 1;
}

}  // namespace hair
