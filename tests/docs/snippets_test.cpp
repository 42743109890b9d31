// Programs of docs/concepts, compiled and run; check_pages.py compares them line by line.
#include <filesystem>
#include <iostream>
#include <sstream>

#include <gtest/gtest.h>

#include <libhair/core/error.h>
#include <libhair/files/strand_file.h>
#include <libhair/measure/shadow/choose.h>
#include <libhair/model/head.h>
#include <libhair/model/styles.h>
#include <libhair/shadow/methods/shadow_method.h>
#include <libhair/simulation/frame.h>
#include <libhair/wisps/bind.h>

TEST(ConceptPages, StrandsAreTwoArrays) {
  // clang-format off
  std::vector<glm::vec3> points = {{0, 0, 0}, {0, -0.1f, 0},                      // one strand
                                   {0.01f, 0, 0}, {0.01f, -0.1f, 0}, {0, -0.2f, 0}};  // another
  std::vector<std::uint32_t> first = {0, 2, 5};
  const hair::StrandView strands{points, first};
  hair::validate(strands, "my strands");  // throws Error where something is wrong
  // clang-format on
  EXPECT_EQ(strands.strandCount(), 2u);
  first.back() = 6;
  EXPECT_THROW(hair::validate({points, first}, "my strands"), hair::Error);
}

TEST(ConceptPages, ALoadedFileBecomesAGroom) {
  const std::filesystem::path path = std::filesystem::path(HAIR_MODELS_DIR) / "smooth.hair";
  hair::StrandFile file = hair::readStrands(path);  // any format: metres, +Y up
  hair::dropDegenerate(file);                       // strands without a direction
  const hair::Groom groom = hair::bindGroom(file.strands, {.guides = 60});
  EXPECT_EQ(groom.guideCount(), 60u);
  EXPECT_EQ(groom.strandCount(), file.strands.strandCount());
}

TEST(ConceptPages, SettingsAreChosenFromABudget) {
  const hair::MeshSdf headSdf(hair::builtinHead().mesh, 0.006f, 0.03f);
  hair::StyleSettings style = hair::styleSettings(hair::Style::Smooth);
  style.strands = 2000;
  const hair::Groom groom = hair::makeGroom(style, headSdf);
  const hair::Fibre fibre = groom.fibre;
  const hair::Hair hair(groom, {}, {}, nullptr);
  const hair::StrandView strands = hair.strands();
  std::ostringstream said;
  std::streambuf* before = std::cout.rdbuf(said.rdbuf());

  const hair::MachineCosts machine = hair::calibrate(strands, fibre, 1);
  const hair::LightSpace light = hair::makeLightSpace({0.5f, -0.8f, 0.35f});
  const float footprint = 3e-3f;  // metres over which a shadow is averaged
  const hair::ShadowChoice choice =
      hair::chooseShadow(strands, fibre, light, footprint, {.maxError = 0.05}, machine);
  std::cout << choice.predicted.candidate.label << ": " << choice.reason << '\n';
  const auto method = hair::makeShadowMethod(choice.predicted.candidate.settings);

  std::cout.rdbuf(before);
  EXPECT_LE(choice.predicted.cautiousError(), 0.05);
  EXPECT_NE(said.str().find(": "), std::string::npos);
  method->build(strands, fibre, light);
  EXPECT_GT(method->bytes(), 0u);
}
