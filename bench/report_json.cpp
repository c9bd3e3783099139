// The report as JSON.

#include "figures.h"

#include <nlohmann/json.hpp>

namespace glint::bench {
namespace {

using Json = nlohmann::ordered_json;

Json timing_json(const std::vector<Timing>& rounds) {
    Json cpu = Json::array();
    Json wall = Json::array();
    for (const Timing& round : rounds) {
        cpu.push_back(round.cpu);
        wall.push_back(round.wall);
    }
    return {{"cpu_seconds", cpu}, {"wall_seconds", wall}};
}

Json set_json(const SetResult& set) {
    Json json{{"set", set.set}, {"rays", set.rays}, {"differing_bits", set.our_differences}};
    for (std::size_t i = 0; i < set.peers.size(); ++i) {
        Json peer{{"name", set.peers[i].name},
                  {"mrays_per_cpu_second", median_rate(set, i)},
                  {"differing_answers", set.peer_differences[i]}};
        if (i > 0) peer["glint_ratio"] = median_ratio(set, i);
        peer.update(timing_json(set.timings[i]));
        json["peers"].push_back(peer);
    }
    for (const Group group : {Group::embree, Group::robust})
        if (const std::size_t best = best_of(set, group); best > 0)
            json[group == Group::embree ? "ratio_to_best" : "ratio_to_best_robust"] = median_ratio(set, best);
    if (!set.threads.empty())
        json["threads"] = {{"one", timing_json(set.threads[0])}, {"two", timing_json(set.threads[1])}};
    return json;
}

Json build_json(const ModelResult& model, std::size_t builder) {
    const BuildMedians found = build_medians(model, builder);
    Json json{{"builder", model.builds[builder].builder},
              {"mtri_per_cpu_second", found.rate},
              {"own_bytes_per_triangle", found.own},
              {"held_bytes_per_triangle", found.held},
              {"peak_bytes_per_triangle", found.peak}};
    if (found.ratio > 0) json["ratio_to_embree"] = found.ratio;
    for (const BuildFigures& round : model.builds[builder].rounds) json["cpu_seconds"].push_back(round.cpu);
    return json;
}

} // namespace

std::string json(const Report& report) {
    Json json{{"machine", machine()},
              {"peer", embree_version()},
              {"simd", report.options.simd},
              {"embree_isa", report.options.isa},
              {"size", report.options.jobs.size},
              {"batch", report.options.jobs.batch},
              {"rounds", report.options.rounds}};
    for (const ModelResult& model : report.models) {
        Json entry{{"mesh", model.name}, {"triangles", model.triangles}};
        for (const SetResult& set : model.sets) entry["sets"].push_back(set_json(set));
        for (std::size_t i = 0; i < model.builds.size(); ++i) entry["builds"].push_back(build_json(model, i));
        json["meshes"].push_back(entry);
    }
    return json.dump(2) + "\n";
}

} // namespace glint::bench
