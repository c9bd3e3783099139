// glint-bench: tracing and building rates of glint and Embree per CPU second.

#include "../tests/kit/temporary_folder.h"
#include "agreement.h"
#include "report.h"

#include <fstream>
#include <iostream>
#include <string_view>

namespace glint::bench {
namespace {

SetResult measure_set(const Job& job, const std::vector<Peer>& peers, const std::vector<Peer>& other_variants,
                      const Options& options) {
    SetResult result{job.name, job.rays, peers, time_rounds(job, peers, options.rounds), {}, 0, {}};
    if (options.threads > 1) result.threads = time_threads(job, peers.front(), options.rounds);
    const Answers ours = answers_of(job, peers.front());
    for (const Peer& peer : other_variants)
        result.our_differences += different_bits(ours, answers_of(job, peer));
    for (const Peer& peer : peers)
        result.peer_differences.push_back(different_answers(ours, answers_of(job, peer)));
    return result;
}

/// Builders alternate like peers.
std::vector<BuildResult> measure_builds(const Model& model, int rounds) {
    std::vector<BuildResult> results;
    for (const auto& all : {our_builders(), embree_builders()})
        for (const Builder& builder : all) results.push_back({builder.name, {}});
    for (int round = 0; round < rounds; ++round)
        for (std::size_t turn = 0; turn < results.size(); ++turn) {
            BuildResult& next = results[round % 2 == 0 ? turn : results.size() - 1 - turn];
            next.rounds.push_back(build_in_new_process(next.builder, model.file));
        }
    return results;
}

tracing::SimdTarget target_named(const std::string& name) {
    using tracing::SimdTarget;
    if (name == "plain") return SimdTarget::plain;
    if (name == "sse4") return SimdTarget::sse4;
    if (name == "avx2") return SimdTarget::avx2;
    return name == "avx512" ? SimdTarget::avx512 : SimdTarget::best;
}

ModelResult measure(const Model& model, const Options& options) {
    std::cerr << model.name << ": " << model.mesh->triangles.size() << " triangles\n";
    ModelResult result{model.name, model.mesh->triangles.size(), {}, {}};
    const tracing::Mesh mesh = build_ours(model, tracing::BuildQuality::high, 1);
    std::vector<Peer> peers{our_peer(mesh, target_named(options.simd))};
    for (const Group group : {Group::embree, Group::robust}) {
        if (group == Group::robust && !options.robust) continue;
        for (Peer& peer : embree_peers(model, group, options.isa)) peers.push_back(std::move(peer));
    }
    const std::vector<Peer> other_variants = our_other_variants(model, mesh);
    for (const std::string& set : options.sets) {
        std::cerr << "  " << set << '\n';
        result.sets.push_back(
            measure_set(make_job(set, model, mesh, options.jobs), peers, other_variants, options));
    }
    if (options.builds) {
        std::cerr << "  builds\n";
        result.builds = measure_builds(model, options.rounds);
    }
    return result;
}

int run(const Options& options) {
    Report report{options, {}};
    const test::TemporaryFolder folder;
    for (const std::string& file : options.files) report.models.push_back(measure(load_model(file), options));
    if (options.files.empty())
        for (const char* name : generated_names)
            report.models.push_back(measure(generate_model(name, folder.path()), options));
    std::cout << tables(report) << std::flush;
    if (!options.json.empty() && !(std::ofstream(options.json) << json(report)))
        throw std::runtime_error(options.json + " cannot be written");
    if (agrees(report)) return 0;
    std::cerr << "glint-bench: answers differ\n";
    return 1;
}

} // namespace
} // namespace glint::bench

int main(int argc, char** argv) {
    try {
        if (argc == 4 && std::string_view(argv[1]) == "--build-only")
            return glint::bench::build_and_report(argv[2], argv[3]) ? 0 : 2;
        const glint::bench::Request request = glint::bench::parse_command_line(argc, argv);
        return request.exit_status ? *request.exit_status : glint::bench::run(request.options);
    } catch (const std::exception& error) {
        std::cerr << "glint-bench: " << error.what() << '\n';
        return 3;
    }
}
