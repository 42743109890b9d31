#include <apps/dance/panel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <utility>

#include <imgui.h>

#include <apps/dance/times_plot.h>
#include <libhair/shade/srgb.h>

namespace hair {

namespace {

const ImVec4 kWarning{1.0f, 0.7f, 0.2f, 1.0f};

struct HairColour {
  const char* name;
  glm::vec3 root, tip;  // linear
};
constexpr std::array<HairColour, 7> kHairColours = {{
    {"black", {0.012f, 0.010f, 0.009f}, {0.022f, 0.018f, 0.016f}},
    {"dark brown", {0.045f, 0.022f, 0.012f}, {0.080f, 0.040f, 0.022f}},
    {"brown", {0.115f, 0.055f, 0.026f}, {0.190f, 0.098f, 0.047f}},
    {"auburn", {0.210f, 0.045f, 0.016f}, {0.340f, 0.085f, 0.030f}},
    {"red", {0.330f, 0.085f, 0.022f}, {0.480f, 0.150f, 0.045f}},
    {"blond", {0.340f, 0.200f, 0.085f}, {0.520f, 0.360f, 0.190f}},
    {"grey", {0.260f, 0.250f, 0.240f}, {0.420f, 0.410f, 0.400f}},
}};

template <class T>
void choose(const char* label, T& value, std::initializer_list<std::pair<T, const char*>> choices) {
  const char* shown = "other";
  for (const auto& [choice, name] : choices)
    if (choice == value) shown = name;
  if (!ImGui::BeginCombo(label, shown)) return;
  for (const auto& [choice, name] : choices)
    if (ImGui::Selectable(name, choice == value)) value = choice;
  ImGui::EndCombo();
}

float linearFromSrgb(float s) {
  return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
}

// Edited as it looks, kept linear. True if it was changed.
bool editColour(const char* label, glm::vec3& linear) {
  glm::vec3 srgb;
  for (int c = 0; c < 3; ++c) srgb[c] = srgbFromLinear(linear[c]);
  if (!ImGui::ColorEdit3(label, &srgb.x)) return false;
  for (int c = 0; c < 3; ++c) linear[c] = linearFromSrgb(srgb[c]);
  return true;
}

void drawState(const Readout& r) {
  ImGui::Text("%.1f pictures/s, time at %.2f of real", r.picturesPerSecond, r.simulatedPerSecond);
  if (r.duration > 0)
    ImGui::Text("%.2f s of %.2f s of motion", std::fmod(r.time, r.duration), r.duration);
  else
    ImGui::Text("%.2f s, nobody moves", r.time);
  ImGui::Text("%zu strands, %zu points", r.strands, r.points);
  ImGui::Text("%zu guides, %zu points", r.guides, r.guidePoints);
  if (r.droppedSeconds > 0)
    ImGui::TextColored(kWarning, "%.1f s dropped: drawing is too slow", r.droppedSeconds);
  if (r.saturatedCells > 0)
    ImGui::TextColored(kWarning, "%u cells of the map are saturated", r.saturatedCells);
  if (r.enlarged) ImGui::TextColored(kWarning, "hair is larger than the map: cells are larger");
  if (!r.failure.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, kWarning);
    ImGui::TextWrapped("%s", r.failure.c_str());
    ImGui::PopStyleColor();
  }
}

Requests drawPlayback(Controls& c) {
  Requests requests;
  if (ImGui::Button(c.paused ? "Go on" : "Pause")) c.paused = !c.paused;
  ImGui::SameLine();
  requests.step = ImGui::Button("Step");
  ImGui::SameLine();
  requests.reset = ImGui::Button("Reset");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-ImGui::CalcTextSize(" speed").x);
  ImGui::SliderFloat("speed", &c.speed, 0.05f, 3, "%.2f",
                     ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
  return requests;
}

bool drawGrowth(Controls::Growth& growth, const Readout& r) {
  constexpr std::array<const char*, 3> kStyles = {"smooth", "curly", "long"};
  const char* shown =
      growth.fromFile ? r.hairFile.c_str() : kStyles[static_cast<std::size_t>(growth.style)];
  bool grow = false;
  if (ImGui::BeginCombo("style", shown)) {
    const auto offer = [&](const char* name, Controls::Growth choice) {
      const bool here = choice.fromFile == growth.fromFile && choice.style == growth.style;
      if (ImGui::Selectable(name, here) && !here) growth = choice, grow = true;
    };
    if (!r.hairFile.empty()) offer(r.hairFile.c_str(), {true, growth.style, 0});
    for (std::size_t s = 0; s < kStyles.size(); ++s)
      offer(kStyles[s], {false, static_cast<Style>(s), 0});
    ImGui::EndCombo();
  }
  int strands = growth.strands > 0 ? growth.strands : static_cast<int>(r.strands);
  if (ImGui::SliderInt("strands", &strands, 200, 30000, "%d", ImGuiSliderFlags_Logarithmic))
    growth.strands = std::max(200, strands);
  ImGui::BeginDisabled(growth == r.grown);
  grow |= ImGui::Button("Grow so many");
  ImGui::EndDisabled();
  return grow;
}

void drawColour(Controls& c) {
  const char* shown = c.ownLook ? "the hair's own" : "mixed";
  for (const HairColour& colour : kHairColours)
    if (!c.ownLook && colour.root == c.look.rootColour && colour.tip == c.look.tipColour)
      shown = colour.name;
  if (ImGui::BeginCombo("hair", shown)) {
    if (ImGui::Selectable("the hair's own", c.ownLook)) c.ownLook = true;
    for (const HairColour& colour : kHairColours)
      if (ImGui::Selectable(colour.name, colour.name == shown)) {
        c.look.rootColour = colour.root, c.look.tipColour = colour.tip;
        c.ownLook = false;
      }
    ImGui::EndCombo();
  }
  bool edited = editColour("roots", c.look.rootColour);
  edited |= editColour("tips", c.look.tipColour);
  edited |= ImGui::SliderFloat("variation", &c.look.variation, 0, 1, "%.2f");
  edited |= ImGui::SliderFloat("gloss", &c.look.specular, 0, 0.6f, "%.2f");
  if (edited) c.ownLook = false;
}

void drawShadow(Controls& c, const Readout& r) {
  using V = ShadowView;
  const auto radio = [&](const char* name, V view) {
    if (ImGui::RadioButton(name, c.shadow.view == view)) c.shadow.view = view;
  };
  radio("off", V::Off), ImGui::SameLine();
  radio("on", V::On), ImGui::SameLine();
  radio("side by side", V::SideBySide);
  choose<int>("cells", c.shadow.cells,
              {{32, "32"}, {64, "64"}, {128, "128"}, {256, "256"}, {512, "512"}});
  choose<Deposit>("deposit", c.shadow.deposit,
                  {{Deposit::Points, "points (paper)"},
                   {Deposit::Columns, "columns"},
                   {Deposit::Segments, "segments"}});
  choose<Filter>("filter", c.shadow.filter,
                 {{Filter::None, "none"},
                  {Filter::Paper, "paper"},
                  {Filter::Centred, "centred"},
                  {Filter::Footprint, "over two cells"}});
  ImGui::Text("a cell measures %.1f mm", 1000 * static_cast<double>(r.cellSize));
  ImGui::Checkbox("head and body shadow the hair", &c.headShadowsHair);
}

void drawSelfCollision(Controls::SelfCollision& c) {
  ImGui::Checkbox("on", &c.on);
  ImGui::BeginDisabled(!c.on);
  choose<RepulsionKind>("away from", c.kind,
                        {{RepulsionKind::CellCentre, "cell centre (paper)"},
                         {RepulsionKind::Gradient, "dense hair (gradient)"}});
  ImGui::SliderFloat("strength", &c.strength, 0, 40, "%.0f m/s2");
  ImGui::EndDisabled();
}

void drawWind(Controls::Breeze& c) {
  ImGui::SliderFloat("speed", &c.speed, 0, 12, "%.1f m/s");
  ImGui::SliderFloat("towards", &c.towards, -180, 180, "%.0f deg");
  ImGui::SliderFloat("up", &c.up, -90, 90, "%.0f deg");
  ImGui::SliderFloat("gusts", &c.gust, 0, 1, "%.2f");
}

void drawPicture(Controls& c, const Readout& r) {
  using P = draw::HairPrimitive;
  if (ImGui::RadioButton("lines", c.primitive == P::Lines)) c.primitive = P::Lines;
  ImGui::SameLine();
  if (ImGui::RadioButton("ribbons", c.primitive == P::Ribbons)) c.primitive = P::Ribbons;
  choose<int>("samples a pixel", c.samples, {{1, "1"}, {2, "2"}, {4, "4"}, {8, "8"}});
  ImGui::Checkbox("camera goes with the head", &c.follow);
  ImGui::Checkbox("floor", &c.ground);
  if (r.softwareDrawing) ImGui::TextUnformatted("drawn by the CPU: no graphics card");
}

void drawMesh(Controls& c, const Readout& r, Requests& requests) {
  ImGui::Checkbox("edit: drag blue vertices", &c.editMesh);
  ImGui::Checkbox("mesh", &c.internals.mesh);
  ImGui::SameLine();
  ImGui::Checkbox("interior", &c.internals.meshInside);
  ImGui::SameLine();
  ImGui::Checkbox("surface, no hair", &c.internals.meshSurface);
  ImGui::BeginDisabled(!r.canUndo);
  requests.undo = ImGui::Button("undo");
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::BeginDisabled(!r.canRedo);
  requests.redo = ImGui::Button("redo");
  ImGui::EndDisabled();
  if (!r.editFailure.empty()) ImGui::TextWrapped("%s", r.editFailure.c_str());
  if (r.editMilliseconds > 0)
    ImGui::Text("last edit: %.1f ms, %u iterations", r.editMilliseconds, r.placementIterations);
}

void drawInternals(Controls& c) {
  for (std::size_t i = 0; i < kInsideCount; ++i)
    ImGui::Checkbox(std::string(insideName(static_cast<Inside>(i))).c_str(),
                    &c.internals.insides[i]);
  ImGui::Checkbox("occupied cells, by transmittance", &c.internals.cells);
  if (c.internals.cells && c.shadow.view == ShadowView::Off)
    ImGui::TextUnformatted("no map: self-shadowing is off");
  if (c.internals.cells) ImGui::TextUnformatted("yellow: lit, blue: dark");
  ImGui::Checkbox("through everything", &c.internalsOnTop);
}

template <class Body>
bool section(const char* name, bool open, Body body) {
  if (!ImGui::CollapsingHeader(name, open ? ImGuiTreeNodeFlags_DefaultOpen : 0)) return false;
  ImGui::PushID(name);
  body();
  ImGui::PopID();
  return true;
}

}  // namespace

Requests drawPanel(Controls& c, Readout& r) {
  const float em = ImGui::GetFontSize();
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({std::min(26 * em, 0.5f * display.x), display.y});
  Requests requests;
  r.timesShown = false;
  if (ImGui::Begin("Hair (Tab hides this)", nullptr,
                   ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
    r.panelWidth = ImGui::GetWindowWidth();
    ImGui::PushItemWidth(-9 * em);
    requests = drawPlayback(c);
    drawState(r);
    section("Hair", true, [&] { requests.grow = drawGrowth(c.growth, r); });
    if (r.hasMesh) section("Hair mesh", true, [&] { drawMesh(c, r, requests); });
    section("Colour", false, [&] { drawColour(c); });
    section("Self-shadowing", true, [&] { drawShadow(c, r); });
    section("Self-collision", false, [&] { drawSelfCollision(c.selfCollision); });
    section("Wind", false, [&] { drawWind(c.wind); });
    section("Picture", false, [&] { drawPicture(c, r); });
    section("Internals", false, [&] { drawInternals(c); });
    r.timesShown = section("Times", true, [&] { drawTimes(r.history, r.softwareDrawing); });
    section("Keys", false, [] {
      ImGui::TextWrapped(
          "left drag: turn; middle drag: slide; wheel: nearer or away; right drag, or shift and "
          "left drag: move the first light; space: pause; S: one frame; R: from the start; Tab: "
          "panel");
    });
    if (!r.notes.empty())
      section("Notes on loading", false, [&] {
        for (const std::string& note : r.notes) ImGui::TextWrapped("%s", note.c_str());
      });
    ImGui::PopItemWidth();
  } else {
    r.panelWidth = 0;
  }
  ImGui::End();
  return requests;
}

void drawNotice(const std::string& text) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 at{0.5f * (display.x - size.x), 0.5f * (display.y - size.y)};
  const float rim = ImGui::GetFontSize();
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  list.AddRectFilled({at.x - rim, at.y - rim}, {at.x + size.x + rim, at.y + size.y + rim},
                     IM_COL32(20, 20, 24, 230), 0.5f * rim);
  list.AddText(at, IM_COL32_WHITE, text.c_str());
}

}  // namespace hair
