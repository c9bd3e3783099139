#pragma once
// A folder with a few small inputs, in which glint runs.

#include "../kit/temporary_folder.h"
#include "process.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace glint::test {

/// Holds at the start of every test: good.toml (16×12 pixels, 1 sample), dark.toml (valid, without light:
/// warns), bad.toml (two errors of meaning), long.toml (renders for hours), mesh.ply, empty/ (a folder),
/// garbage.png.
class CliTest : public testing::Test {
  public:
    CliTest();

    /// Runs `glint LINE`, split at blanks.
    Outcome glint(const std::string& line, Setting setting = {}) const;

    std::string path(const std::string& name) const { return folder_.at(name); }
    bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }
    std::string content(const std::string& name) const;
    void write(const std::string& name, const std::string& text) const { folder_.write(name, text); }
    /// A float picture, every value of it the same.
    void write_pfm(const std::string& name, int width, int height, float value) const;
    /// Every file in the folder, sorted, joined by blanks.
    std::string listing() const;

    /// As on a machine on which no driver is found.
    static Setting without_devices();
    /// Does --backend gpu find a device it can use?
    bool has_device(const Setting& setting = {}) const;

  private:
    const TemporaryFolder folder_;
};

/// Ends a test where --backend gpu cannot be had, and says so.
#define GLINT_NEEDS_DEVICE()                                                                                 \
    if (!has_device()) GTEST_SKIP() << "no device: " << glint("info --devices").out

} // namespace glint::test
