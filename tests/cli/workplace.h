#pragma once
// A folder with a few small inputs, in which glint runs.

#include "process.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace glint::test {

/// Holds at the start of every test: good.toml (16×12 pixels, 1 sample), dark.toml (valid, without light:
/// warns), bad.toml (two errors of meaning), long.toml (renders for hours), mesh.ply, empty/ (a folder),
/// garbage.png.
class Workplace : public testing::Test {
  public:
    Workplace();
    ~Workplace() override;

    /// Runs `glint LINE`, split at blanks.
    Outcome glint(const std::string& line, Setting setting = {}) const;

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
    std::string content(const std::string& name) const;
    void write(const std::string& name, const std::string& text) const;
    /// A float picture, every value of it the same.
    void write_pfm(const std::string& name, int width, int height, float value) const;
    /// Every file in the folder, sorted, joined by blanks.
    std::string listing() const;

  private:
    std::filesystem::path folder_;
};

} // namespace glint::test
