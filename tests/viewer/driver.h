#pragma once
// glint-view on a screen of its own, moved by mouse and keys. Where widgets are and what is shown is read
// from the file that --ui-map keeps.

#include "child.h"

#include "glint/image.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace glint::test {

struct Spot {
    double x = 0;
    double y = 0;
};

/// Starts Xvfb for every test; skips where it, xdotool or OpenGL is missing.
class Screen : public testing::Test {
  protected:
    void SetUp() override;
    void TearDown() override;

    /// Opens the window with a file of the test's folder, or none, and waits for its first map.
    void open(const std::string& file, const std::vector<std::string>& options = {});
    void write(const std::string& name, const std::string& text) const;
    std::string content(const std::string& name) const;
    bool exists(const std::string& name) const;
    std::string path(const std::string& name) const;

    /// The map as it is now.
    nlohmann::json map() const;
    nlohmann::json state(const std::string& name) const;
    bool has(const std::string& widget) const;
    /// The middle of a widget, or a place in it by shares of its width and height.
    Spot spot(const std::string& widget, double across = 0.5, double down = 0.5) const;

    /// Waits until it holds; false after half a minute.
    bool wait_until(const std::function<bool()>& holds) const;
    bool wait_for_state(const std::string& name, const nlohmann::json& value) const;
    bool wait_for_widget(const std::string& widget) const;
    /// Waits until the picture is finished, and returns its hash.
    std::string finished_picture() const;

    void click(const std::string& widget) const;
    void click(const Spot& at, const std::string& button = "1") const;
    void drag(const Spot& from, const Spot& to, const std::string& key = "",
              const std::string& button = "1") const;
    void press(const std::string& key) const;
    void wheel(const Spot& at, int notches) const;
    /// The pixels of the whole window, by its own F12.
    Image screenshot();
    /// How many values of a picture are not what the window shows there, among every seventh pixel.
    int wrong_on_screen(const Image& file);

    /// Asks the window to close by its key and returns the seconds until the program ended; −1: it did not.
    double seconds_to_close();

    Child& viewer() { return *viewer_; }
    const std::string& display() const { return display_; }
    std::string log() const { return content("log"); }

  private:
    std::vector<std::string> display_setting() const;
    void xdotool(const std::string& line) const;

    std::string folder_;
    std::string display_;
    std::unique_ptr<Child> server_;
    std::unique_ptr<Child> viewer_;
};

} // namespace glint::test
