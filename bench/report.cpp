// Tables in Markdown.

#include "report.h"

#include "figures.h"

#include <fmt/format.h>

#include <fstream>
#include <thread>

namespace glint::bench {
namespace {

std::string row(const std::vector<std::string>& cells) {
    std::string line = "|";
    for (const std::string& cell : cells) line += " " + cell + " |";
    return line + "\n";
}

/// The header row and its separator; numbers are right-aligned.
std::string head(const std::vector<std::string>& names, std::size_t text_columns) {
    std::string line = row(names) + "|";
    for (std::size_t i = 0; i < names.size(); ++i) line += i < text_columns ? "---|" : "---:|";
    return line + "\n";
}

std::string rate(double value) { return fmt::format("{:.1f}", value); }
std::string ratio(double value) { return value > 0 ? fmt::format("{:.2f}", value) : "–"; }

/// "Embree packet8" without the name of its column.
std::string short_name(const Peer& peer) { return peer.name.substr(peer.name.rfind(' ') + 1); }

std::string ray_table(const Report& report, Group group) {
    std::vector<std::string> names{"mesh", "triangles", "set", "rays", "glint"};
    std::vector<double> ratios;
    std::string lines;
    for (const ModelResult& model : report.models)
        for (const SetResult& set : model.sets) {
            std::vector<std::string> cells{model.name, fmt::format("{}", model.triangles), set.set,
                                           fmt::format("{}", set.rays), rate(median_rate(set, 0))};
            if (lines.empty())
                for (const Peer& peer : set.peers)
                    if (peer.group == group && group != Group::ours) names.push_back(short_name(peer));
            for (std::size_t i = 1; i < set.peers.size(); ++i)
                if (set.peers[i].group == group) cells.push_back(rate(median_rate(set, i)));
            const double against = median_ratio(set, best_of(set, group));
            if (group != Group::ours) cells.push_back(ratio(against));
            if (against > 0) ratios.push_back(against);
            lines += row(cells);
        }
    if (group != Group::ours) names.push_back("glint ÷ best");
    const std::string mean =
        ratios.empty() || group == Group::ours
            ? ""
            : fmt::format("\nGeometric mean of {} cells: {:.2f}\n", ratios.size(), geometric_mean(ratios));
    return head(names, 3) + lines + mean;
}

std::string thread_table(const Report& report) {
    std::string text = head({"mesh", "set", "1 thread", "2 threads", "2 ÷ 1", "CPU ÷ wall", "rounds"}, 2);
    for (const ModelResult& model : report.models)
        for (const SetResult& set : model.sets) {
            const ThreadFigures found = thread_figures(set);
            text += row({model.name, set.set, rate(found.one), rate(found.two), ratio(found.ratio),
                         ratio(found.cores), fmt::format("{} of {}", found.full_rounds, found.rounds)});
        }
    return text;
}

std::string build_table(const Report& report) {
    std::string text = head({"mesh", "builder", "Mtri a CPU second", "ratio", "own bytes a triangle",
                             "held bytes a triangle", "peak bytes a triangle"},
                            2);
    for (const ModelResult& model : report.models)
        for (std::size_t i = 0; i < model.builds.size(); ++i) {
            const BuildMedians found = build_medians(model, i);
            text += row({model.name, model.builds[i].builder, fmt::format("{:.2f}", found.rate),
                         ratio(found.ratio), rate(found.own), rate(found.held), rate(found.peak)});
        }
    return text;
}

std::string agreement_table(const Report& report) {
    std::string text = head({"mesh", "set", "glint's ways, bits", "Embree, answers", "robust, answers"}, 2);
    for (const ModelResult& model : report.models)
        for (const SetResult& set : model.sets) {
            std::uint64_t max_differences[2] = {0, 0};
            for (std::size_t i = 1; i < set.peers.size(); ++i) {
                std::uint64_t& max = max_differences[set.peers[i].group == Group::robust ? 1 : 0];
                max = std::max(max, set.peer_differences[i]);
            }
            text += row({model.name, set.set, fmt::format("{}", set.our_differences),
                         fmt::format("{}", max_differences[0]), fmt::format("{}", max_differences[1])});
        }
    return text;
}

bool has_group(const Report& report, Group group) {
    for (const ModelResult& model : report.models)
        for (const SetResult& set : model.sets)
            for (const Peer& peer : set.peers)
                if (peer.group == group) return true;
    return false;
}

bool has_sets(const Report& report) { return !report.models.empty() && !report.models.front().sets.empty(); }

} // namespace

std::string tables(const Report& report) {
    const Options& options = report.options;
    std::string text = machine() + "\n\n";
    const bool peers = has_group(report, Group::embree);
    if (has_sets(report)) {
        text += fmt::format("Mrays a CPU second, one thread, {} × {} pixels, {} rays a call (frame: 64), "
                            "medians of {} rounds{}{}:\n\n",
                            options.jobs.size, options.jobs.size, options.jobs.batch, options.rounds,
                            options.simd.empty() ? "" : "; glint with no more than " + options.simd,
                            peers ? "; against " + embree_version() + ", HIGH" +
                                        (options.isa.empty() ? "" : ", no more than " + options.isa)
                                  : "");
        text += ray_table(report, peers ? Group::embree : Group::ours);
        if (has_group(report, Group::robust))
            text += "\nAgainst scenes with Embree's ROBUST flag:\n\n" + ray_table(report, Group::robust);
        if (options.threads > 1)
            text += "\nMrays a wall second of glint; ratios of rounds with CPU ÷ wall ≥ 1.9:\n\n" +
                    thread_table(report);
        text +=
            "\nWhere answers differ (counts; Embree's most of three kernels):\n\n" + agreement_table(report);
    }
    if (options.builds)
        text += "\nBuilds on one thread, each in a new process; own: tree and leaves by the library's count, "
                "held and peak: resident memory; ratio: fast to MEDIUM, high to HIGH:\n\n" +
                build_table(report);
    return text;
}

std::string machine() {
    std::string model = "unknown processor";
    std::ifstream processors("/proc/cpuinfo");
    for (std::string line; std::getline(processors, line);)
        if (line.rfind("model name", 0) == 0) {
            model = line.substr(line.find(':') + 2);
            break;
        }
    std::string load;
    std::ifstream("/proc/loadavg") >> load;
    return fmt::format("{}, {} cores, load {}, g++/clang++ {}", model, std::thread::hardware_concurrency(),
                       load, __VERSION__);
}

bool agrees(const Report& report) {
    for (const ModelResult& model : report.models)
        for (const SetResult& set : model.sets) {
            if (set.our_differences > 0) return false;
            for (const std::uint64_t differences : set.peer_differences)
                if (differences * 100 > set.rays) return false;
        }
    return true;
}

} // namespace glint::bench
