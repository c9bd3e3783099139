#pragma once
// The box in which a file is chosen: scenes and meshes of a folder, and the folder of examples.

#include "ui_map.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace glint::viewer {

struct Ui;

class OpenBox {
  public:
    /// Starts in the working directory.
    OpenBox();

    void toggle() { open_ = !open_; }
    /// False if the box was not open.
    bool close();

    /// Draws the box over the picture's space if it is open, or `always`, where there is no picture. The file
    /// that is chosen now, if any.
    std::optional<std::string> draw(Ui& ui, const Area& space, bool always);

  private:
    void enter(const std::filesystem::path& folder);
    std::optional<std::string> draw_list(Ui& ui);

    std::filesystem::path folder_;
    std::vector<std::string> folders_; ///< names within it, sorted; ".." first
    std::vector<std::string> files_;
    std::filesystem::path examples_; ///< empty if they are not installed
    bool open_ = false;
};

} // namespace glint::viewer
