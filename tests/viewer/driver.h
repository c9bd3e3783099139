#pragma once
// Drives glint-view on an X server of its own by mouse and keys. Positions of widgets and the state of the
// window come from the file of --ui-map.

#include "../kit/temporary_folder.h"
#include "child.h"

#include "glint/image.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace glint::test {

/// A position on the screen.
struct Spot {
    double x = 0;
    double y = 0;
};

/// Starts Xvfb for every test; skips without Xvfb, xdotool or OpenGL.
class Screen : public testing::Test {
  protected:
    void SetUp() override;
    void TearDown() override;

    /// Opens the window with a file of the test's folder, or none, and waits for its first map.
    void open(const std::string& file, const std::vector<std::string>& options = {},
              const std::vector<std::string>& environment = {});
    void write(const std::string& name, const std::string& text) const;
    std::string content(const std::string& name) const;
    bool exists(const std::string& name) const;
    /// The files of the test's folder that begin with this.
    int count(const std::string& beginning) const;
    std::string path(const std::string& name) const;

    /// The current map.
    nlohmann::json map() const;
    nlohmann::json state(const std::string& name) const;
    bool has(const std::string& widget) const;
    /// A position in a widget, by fractions of its width and height.
    Spot spot(const std::string& widget, double u = 0.5, double v = 0.5) const;

    /// Waits until the condition holds; false after 30 seconds.
    bool wait_until(const std::function<bool()>& holds) const;
    bool wait_for_state(const std::string& name, const nlohmann::json& value) const;
    bool wait_for_widget(const std::string& widget) const;
    /// Waits for the finished picture and returns its hash.
    std::string finished_picture() const;

    void click(const std::string& widget) const;
    void click(const Spot& at, const std::string& button = "1") const;
    void drag(const Spot& from, const Spot& to, const std::string& key = "",
              const std::string& button = "1") const;
    void press(const std::string& key) const;
    void wheel(const Spot& at, int notches) const;
    /// The window's content, saved with F12.
    Image screenshot();
    /// Number of values, in every seventh pixel of a picture, that the window shows differently.
    int wrong_on_screen(const Image& file);

    /// Closes the window by its key; returns the seconds until the program ended, −1 if it did not.
    double seconds_to_close();

    Child& viewer() { return *viewer_; }
    const std::string& display() const { return display_; }
    std::string log() const { return content("log"); }

  private:
    std::vector<std::string> display_setting() const;
    void xdotool(const std::string& line) const;

    std::unique_ptr<TemporaryFolder> folder_;
    std::string display_;
    std::unique_ptr<Child> server_;
    std::unique_ptr<Child> viewer_;
};

} // namespace glint::test
