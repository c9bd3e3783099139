// The shaders by another compiler than a driver's, and under Vulkan's rules.

#include "gpu/program.h"

#include "../kit/temporary_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace glint::gpu {
namespace {

class GpuShaders : public testing::Test {
  protected:
    void SetUp() override {
        if (std::system("command -v glslangValidator >/dev/null") != 0)
            GTEST_SKIP() << "glslangValidator is not installed (Debian: glslang-tools)";
    }

    /// What the compiler says against it.
    std::string complaint(const std::string& source) const {
        folder_.write("shader.comp", source);
        const std::string command =
            "cd '" + folder_.path().string() + "' && glslangValidator -V -o shader.spv shader.comp 2>&1";
        FILE* said = popen(command.c_str(), "r");
        if (said == nullptr) throw std::runtime_error("no process can be started");
        std::string text;
        std::array<char, 4096> part{};
        while (const std::size_t bytes = std::fread(part.data(), 1, part.size(), said))
            text.append(part.data(), bytes);
        return pclose(said) == 0 ? std::string() : readable_log(text);
    }

  private:
    const test::TemporaryFolder folder_;
};

/// All that is ever compiled, but for the size of stacks.
std::vector<ProgramChoice> all_choices() {
    std::vector<ProgramChoice> choices;
    for (const bool glass : {false, true}) {
        for (const auto& [instances, contacts] : {std::pair(false, false), {true, false}, {false, true}}) {
            ProgramChoice c;
            c.glass = glass;
            c.instances = instances;
            c.contacts = contacts;
            choices.push_back(c);
            c.terms = true;
            choices.push_back(c);
            c.terms = false;
            c.first_hit = true;
            choices.push_back(c);
            c.first_hit = false;
            c.rays = true;
            choices.push_back(c);
            c.count = true;
            choices.push_back(c);
        }
    }
    return choices;
}

TEST_F(GpuShaders, CompileForVulkan) {
    for (const ProgramChoice& c : all_choices())
        EXPECT_EQ(complaint(shader_source(c)), "")
            << "glass " << c.glass << ", instances " << c.instances << ", contacts " << c.contacts
            << ", terms " << c.terms << ", first hits " << c.first_hit << ", rays " << c.rays << ", counts "
            << c.count;
    EXPECT_EQ(complaint(show_source()), "");
}

TEST_F(GpuShaders, AMistakeIsNamedByFileAndLine) {
    std::string source = shader_source({});
    const std::string sound = "real spot_falloff(";
    ASSERT_NE(source.find(sound), std::string::npos);
    const std::string said =
        complaint(source.replace(source.find(sound), sound.size(), "reel spot_falloff("));
    EXPECT_NE(said.find("shading/whitted.shared.h:"), std::string::npos) << said;
}

} // namespace
} // namespace glint::gpu
