#include <apps/dance/times_plot.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <imgui.h>

#include <libhair/core/error.h>

namespace hair {

namespace {

constexpr std::array<ImU32, kDrawStage> kStageColours = {
    IM_COL32(150, 150, 150, 255),  // motion
    IM_COL32(86, 180, 233, 255),   // guides
    IM_COL32(0, 114, 178, 255),    // wisps
    IM_COL32(204, 121, 167, 255),  // self-collision
    IM_COL32(230, 159, 0, 255),    // deposit
    IM_COL32(213, 94, 0, 255),     // transmittance
    IM_COL32(240, 228, 66, 255),   // filter
    IM_COL32(0, 158, 115, 255),    // shade
};

// The least of 1, 2, 5, 10, 20 ... that is at least x.
float roundedUp(float x) {
  const float decade = std::pow(10.0f, std::floor(std::log10(std::max(x, 1e-3f))));
  for (const float step : {1.0f, 2.0f, 5.0f})
    if (x <= step * decade) return step * decade;
  return 10 * decade;
}

void drawBars(const Recent<FrameProfile>& frames) {
  // By the median: one late frame must not flatten all others. It is cut off at the top.
  const float top = roundedUp(2 * medianOf(frames, withoutDrawing));

  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size{ImGui::GetContentRegionAvail().x, 6 * ImGui::GetFontSize()};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y},
                     ImGui::GetColorU32(ImGuiCol_FrameBg));
  list.PushClipRect(corner, {corner.x + size.x, corner.y + size.y}, true);
  // The newest stands at the right edge.
  const float wide = size.x / static_cast<float>(frames.capacity());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const float right = corner.x + size.x - wide * static_cast<float>(frames.size() - 1 - i);
    float y = corner.y + size.y;
    for (std::size_t s = 0; s < kDrawStage; ++s) {
      const float high = size.y * milliseconds(frames[i][s]) / top;
      if (high > 0) list.AddRectFilled({right - wide, y - high}, {right, y}, kStageColours[s]);
      y -= high;
    }
  }
  list.PopClipRect();
  list.AddText({corner.x + 4, corner.y + 2}, ImGui::GetColorU32(ImGuiCol_Text),
               text(top, " ms").c_str());
  ImGui::Dummy(size);
}

void drawRow(ImU32 colour, const char* name, float median, float last) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float side = ImGui::GetFontSize();
  if (colour != 0)
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + 2}, {at.x + side - 4, at.y + side - 2},
                                              colour);
  ImGui::SetCursorScreenPos({at.x + side, at.y});
  ImGui::TextUnformatted(name);
  ImGui::TableNextColumn();
  ImGui::Text("%8.3f", static_cast<double>(median));
  ImGui::TableNextColumn();
  ImGui::Text("%8.3f", static_cast<double>(last));
}

}  // namespace

void drawTimes(const History& history, bool drawnByCpu) {
  const auto& frames = history.frames;
  ImGui::Text("last %d frames, without drawing", static_cast<int>(frames.size()));
  drawBars(frames);
  if (frames.size() > 0 && ImGui::BeginTable("times", 3, ImGuiTableFlags_SizingStretchProp)) {
    ImGui::TableSetupColumn("stage");
    ImGui::TableSetupColumn("median ms");
    ImGui::TableSetupColumn("last ms");
    ImGui::TableHeadersRow();
    for (std::size_t s = 0; s < kDrawStage; ++s) {
      const float median =
          medianOf(frames, [s](const FrameProfile& frame) { return milliseconds(frame[s]); });
      const float last = milliseconds(frames.last()[s]);
      if (median > 0 || last > 0)
        drawRow(kStageColours[s], stageName(static_cast<Stage>(s)).data(), median, last);
    }
    const float frame = medianOf(frames, withoutDrawing), last = withoutDrawing(frames.last());
    drawRow(0, "without drawing", frame, last);
    const auto& pictures = history.pictures;
    if (pictures.size() > 0) {
      const float drawing = medianOf(pictures, [](float ms) { return ms; });
      drawRow(0, drawnByCpu ? "drawing, by the CPU" : "drawing", drawing, pictures.last());
      drawRow(0, "with drawing", frame + drawing, last + pictures.last());
    }
    ImGui::EndTable();
  }
  if (history.pictures.size() > 1) {
    const auto value = [](void* data, int i) {
      return (*static_cast<const Recent<float>*>(data))[static_cast<std::size_t>(i)];
    };
    ImGui::SetNextItemWidth(-1);
    ImGui::PlotLines("##drawing", value,
                     const_cast<void*>(static_cast<const void*>(&history.pictures)),
                     static_cast<int>(history.pictures.size()), 0, "drawing, ms a picture", 0,
                     roundedUp(2 * medianOf(history.pictures, [](float ms) { return ms; })),
                     {0, 4 * ImGui::GetFontSize()});
  }
}

}  // namespace hair
