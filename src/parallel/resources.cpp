// Reads the limits from /proc and /sys, and asks the system.

#include "parallel/resources.h"

#include <sched.h>
#include <sys/auxv.h>
#include <sys/resource.h>
#include <sys/sysinfo.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <thread>
#include <vector>

namespace glint::parallel {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The numbers in a file: infinite for "max" and below 0; empty if there is no such file.
std::vector<double> numbers_in(const std::string& path) {
    std::ifstream file(path);
    std::vector<double> numbers;
    for (std::string word; file >> word;) {
        double number = unlimited;
        std::from_chars(word.data(), word.data() + word.size(), number);
        numbers.push_back(number < 0 ? unlimited : number);
    }
    return numbers;
}

void take_quota(const std::vector<double>& quota_and_period, double& processors) {
    if (quota_and_period.size() == 2 && quota_and_period[1] > 0)
        processors = std::min(processors, quota_and_period[0] / quota_and_period[1]);
}

/// The limits of one group, whose folder has the files of version 1 or 2.
void take_limits(const std::string& folder, GroupLimits& limits) {
    for (const char* name : {"/memory.max", "/memory.limit_in_bytes"})
        for (const double bytes : numbers_in(folder + name)) limits.memory = std::min(limits.memory, bytes);
    take_quota(numbers_in(folder + "/cpu.max"), limits.processors);
    std::vector<double> quota = numbers_in(folder + "/cpu.cfs_quota_us");
    for (const double period : numbers_in(folder + "/cpu.cfs_period_us")) quota.push_back(period);
    take_quota(quota, limits.processors);
}

/// Processors that the scheduler may give to this process; 0 if the system does not tell.
int allowed_processors() {
    // Room for as many processors as Linux can manage.
    std::vector<cpu_set_t> sets(16);
    const std::size_t bytes = sets.size() * sizeof(cpu_set_t);
    if (::sched_getaffinity(0, bytes, sets.data()) != 0) return 0;
    return CPU_COUNT_S(bytes, sets.data());
}

/// They hardly ever change while a program runs.
const GroupLimits& own_group_limits() {
    static const GroupLimits limits = group_limits();
    return limits;
}

} // namespace

GroupLimits group_limits(const std::string& root) {
    GroupLimits limits;
    const std::string groups = root + "/sys/fs/cgroup";
    take_limits(groups, limits);
    std::ifstream file(root + "/proc/self/cgroup");
    // "4:memory:/group/part" in version 1, "0::/group/part" in version 2. In a container the path may be that
    // outside, which cannot be seen; the root is then the container's own group.
    for (std::string line; std::getline(file, line);) {
        const std::size_t first = line.find(':');
        const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
        if (second == std::string::npos || line.find('/', second) != second + 1) continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        std::string path = line.substr(second + 1);
        const std::string mount = groups + (controllers.empty() ? "" : "/" + controllers);
        for (; !path.empty(); path.resize(path.rfind('/'))) take_limits(mount + path, limits);
        take_limits(mount, limits);
    }
    return limits;
}

int available_threads() {
    int count = allowed_processors();
    if (count == 0) count = static_cast<int>(std::thread::hardware_concurrency());
    const double quota = std::ceil(own_group_limits().processors);
    return static_cast<int>(std::clamp(quota, 1.0, std::max(1.0, double(count))));
}

double memory_limit() {
    double bytes = own_group_limits().memory;
    struct sysinfo machine = {};
    if (::sysinfo(&machine) == 0) bytes = std::min(bytes, double(machine.totalram) * machine.mem_unit);
    // Linux does not enforce RLIMIT_RSS (ulimit -m).
    for (const auto resource : {RLIMIT_AS, RLIMIT_DATA, RLIMIT_RSS}) {
        rlimit limit = {};
        if (::getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
            bytes = std::min(bytes, double(limit.rlim_cur));
    }
    return bytes;
}

double resident_memory() {
    // Its second number counts pages.
    const std::vector<double> pages = numbers_in("/proc/self/statm");
    return pages.size() > 1 ? pages[1] * static_cast<double>(::getauxval(AT_PAGESZ)) : 0;
}

} // namespace glint::parallel
