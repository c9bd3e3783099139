// Limits of control groups, read from prepared folders: tests cannot make groups on every machine.

#include "parallel/resources.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <stdlib.h>

namespace glint::parallel {
namespace {

namespace fs = std::filesystem;

class GroupFolders : public testing::Test {
  public:
    GroupFolders() {
        std::string name = (fs::temp_directory_path() / "glint-test-XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
        root = name;
    }
    ~GroupFolders() override { fs::remove_all(root); }

    void write(const std::string& name, const std::string& text) const {
        const fs::path path = root + name;
        fs::create_directories(path.parent_path());
        std::ofstream(path) << text;
    }

    std::string root;
};

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST_F(GroupFolders, OfVersion2SayTheLeastLimitOfAllGroupsAbove) {
    write("/proc/self/cgroup", "0::/farm/job/step\n");
    write("/sys/fs/cgroup/farm/memory.max", "4000000\n");
    write("/sys/fs/cgroup/farm/cpu.max", "150000 100000\n");
    write("/sys/fs/cgroup/farm/job/memory.max", "300000000\n");
    write("/sys/fs/cgroup/farm/job/step/memory.max", "max\n");
    write("/sys/fs/cgroup/farm/job/step/cpu.max", "max 100000\n");
    EXPECT_EQ(group_limits(root).memory, 4e6);
    EXPECT_EQ(group_limits(root).processors, 1.5);
}

TEST_F(GroupFolders, OfVersion1AreOneForEachController) {
    write("/proc/self/cgroup", "5:memory:/job\n4:cpu,cpuacct:/job\n1:name=systemd:/job\n0::/job\n");
    write("/sys/fs/cgroup/memory/job/memory.limit_in_bytes", "314572800\n");
    write("/sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
    write("/sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_quota_us", "200000\n");
    write("/sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_period_us", "100000\n");
    write("/sys/fs/cgroup/cpu,cpuacct/cpu.cfs_quota_us", "-1\n");
    write("/sys/fs/cgroup/cpu,cpuacct/cpu.cfs_period_us", "100000\n");
    EXPECT_EQ(group_limits(root).memory, 314572800);
    EXPECT_EQ(group_limits(root).processors, 2);
}

TEST_F(GroupFolders, OfAContainerAreTheRootWhereThePathIsThatOutside) {
    write("/proc/self/cgroup", "0::/docker/0123\n");
    write("/sys/fs/cgroup/memory.max", "300000000\n");
    write("/sys/fs/cgroup/cpu.max", "50000 100000\n");
    EXPECT_EQ(group_limits(root).memory, 3e8);
    EXPECT_EQ(group_limits(root).processors, 0.5);
}

TEST_F(GroupFolders, WithoutLimitsSayNone) {
    EXPECT_EQ(group_limits(root).memory, infinity);
    write("/proc/self/cgroup", "nonsense\n0::\n:::\n0::/a\n");
    write("/sys/fs/cgroup/a/cpu.max", "0 0\n");
    write("/sys/fs/cgroup/a/memory.max", "");
    EXPECT_EQ(group_limits(root).memory, infinity);
    EXPECT_EQ(group_limits(root).processors, infinity);
}

TEST(Memory, OfThisProcessIsSomeOfTheMachines) {
    EXPECT_GT(resident_memory(), 1e5);
    EXPECT_GT(memory_limit(), resident_memory());
}

} // namespace
} // namespace glint::parallel
