// Limits of control groups, read from prepared folders: tests cannot make groups on every machine.

#include "parallel/resources.h"

#include "../kit/temporary_folder.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <limits>

namespace glint::parallel {
namespace {

class GroupFolders : public testing::Test {
  protected:
    void write(const std::string& name, const std::string& text) const {
        folder_.write(name.substr(1), text);
    }
    GroupLimits limits() const { return group_limits(folder_.path().string()); }

  private:
    const test::TemporaryFolder folder_;
};

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST_F(GroupFolders, OfVersion2SayTheLeastLimitOfAllGroupsAbove) {
    write("/proc/self/cgroup", "0::/batch/job/step\n");
    write("/sys/fs/cgroup/batch/memory.max", "4000000\n");
    write("/sys/fs/cgroup/batch/cpu.max", "150000 100000\n");
    write("/sys/fs/cgroup/batch/job/memory.max", "300000000\n");
    write("/sys/fs/cgroup/batch/job/step/memory.max", "max\n");
    write("/sys/fs/cgroup/batch/job/step/cpu.max", "max 100000\n");
    EXPECT_EQ(limits().memory, 4e6);
    EXPECT_EQ(limits().processors, 1.5);
}

TEST_F(GroupFolders, OfVersion1AreOneForEachController) {
    write("/proc/self/cgroup", "5:memory:/job\n4:cpu,cpuacct:/job\n1:name=systemd:/job\n0::/job\n");
    write("/sys/fs/cgroup/memory/job/memory.limit_in_bytes", "314572800\n");
    write("/sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
    write("/sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_quota_us", "200000\n");
    write("/sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_period_us", "100000\n");
    write("/sys/fs/cgroup/cpu,cpuacct/cpu.cfs_quota_us", "-1\n");
    write("/sys/fs/cgroup/cpu,cpuacct/cpu.cfs_period_us", "100000\n");
    EXPECT_EQ(limits().memory, 314572800);
    EXPECT_EQ(limits().processors, 2);
}

TEST_F(GroupFolders, OfAContainerAreTheRootWhereThePathIsThatOutside) {
    write("/proc/self/cgroup", "0::/docker/0123\n");
    write("/sys/fs/cgroup/memory.max", "300000000\n");
    write("/sys/fs/cgroup/cpu.max", "50000 100000\n");
    EXPECT_EQ(limits().memory, 3e8);
    EXPECT_EQ(limits().processors, 0.5);
}

TEST_F(GroupFolders, WithoutLimitsSayNone) {
    EXPECT_EQ(limits().memory, infinity);
    write("/proc/self/cgroup", "nonsense\n0::\n:::\n0::/a\n");
    write("/sys/fs/cgroup/a/cpu.max", "0 0\n");
    write("/sys/fs/cgroup/a/memory.max", "");
    EXPECT_EQ(limits().memory, infinity);
    EXPECT_EQ(limits().processors, infinity);
}

TEST(Memory, OfThisProcessIsSomeOfTheMachines) {
    EXPECT_GT(resident_memory(), 1e5);
    EXPECT_GT(memory_limit(), resident_memory());
}

TEST(Memory, OfThisProcessKeepsTheLimitOfUlimit) {
    rlimit before = {};
    ASSERT_EQ(::getrlimit(RLIMIT_RSS, &before), 0);
    rlimit lower = before;
    lower.rlim_cur = 12'345'678;
    ASSERT_EQ(::setrlimit(RLIMIT_RSS, &lower), 0);
    EXPECT_EQ(memory_limit(), 12'345'678);
    ::setrlimit(RLIMIT_RSS, &before);
}

} // namespace
} // namespace glint::parallel
