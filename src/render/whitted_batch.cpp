// Many camera rays at once, breadth first: every level's rays are traced together, light by light its shadow
// rays, and hits are shaded one by one by the steps of whitted.cpp. So the picture is the same to the bit as
// by recursion.

#include "render/whitted.h"

#include <new>

namespace glint {

namespace {

/// Ray trees grow without end where glass meets glass: what has no room here is followed by recursion.
constexpr std::size_t most_flights = 4096;

} // namespace

bool WhittedTracer::has_room() const { return flight_count_ + 2 <= most_flights; }

WhittedTracer::Flight& WhittedTracer::launch() {
    // Clearing a flight would cost as much as lighting it: the caller sets its path, find_hits() the rest.
    Flight& flight = flights_[flight_count_++];
    flight.reflected = -1;
    flight.refracted = -1;
    return flight;
}

void WhittedTracer::trace(std::span<Sample> samples) {
    for (; samples.size() > most_flights; samples = samples.subspan(most_flights))
        trace(samples.first(most_flights));
    if (kernel_.kernel == Kernel::scalar) return trace_alone(samples);
    arena_.clear();
    record_ = nullptr;
    if (flights_.empty()) {
        flights_.resize(most_flights);
        pending_.resize(most_flights);
        rays_.resize(most_flights);
        hits_.resize(most_flights);
        blocked_.resize(most_flights);
    }
    flight_count_ = 0;
    for (const Sample& sample : samples) start_primary(sample.origin, sample.direction, launch().path);

    std::size_t first = 0;
    while (first < flight_count_) {
        if (cancel_ != nullptr && cancel_->load(std::memory_order_relaxed)) return;
        const std::span<Flight> level(flights_.data() + first, flight_count_ - first);
        first = flight_count_;
        find_hits(level);
        for (std::uint32_t i = 0; i < scene_.lights.size(); ++i) light(level, i);
        for (Flight& flight : level)
            if (flight.hit) grow(flight);
    }
    gather();
    for (std::size_t i = 0; i < samples.size(); ++i) {
        samples[i].terms = flights_[i].terms;
        samples[i].covered = static_cast<bool>(flights_[i].hit);
    }
}

void WhittedTracer::trace_alone(std::span<Sample> samples) {
    for (Sample& sample : samples)
        sample.terms = trace(sample.origin, sample.direction, nullptr, &sample.covered);
}

void WhittedTracer::find_hits(std::span<Flight> level) {
    for (std::size_t i = 0; i < level.size(); ++i) {
        rays_[i] = Ray{};
        rays_[i].origin = level[i].path.origin;
        rays_[i].direction = level[i].path.direction;
    }
    scene_.world.closest({rays_.data(), level.size()}, {hits_.data(), level.size()}, RayHint::coherent,
                         scratch_, kernel_);
    for (std::size_t i = 0; i < level.size(); ++i) {
        Flight& flight = level[i];
        flight.hit = hits_[i];
        pass_hidden(rays_[i], flight.hit, flight.path.media);
        if (flight.hit) {
            ::new (&flight.surface) Surface(surface_at(rays_[i], flight.hit)); // made in its place
            start_terms(flight.surface, flight.terms);
        } else {
            flight.terms = missed(flight.path, -1);
        }
    }
}

/// Adds one light to all flights that it can reach.
void WhittedTracer::light(std::span<Flight> level, std::uint32_t index) {
    std::size_t count = 0;
    for (Flight& flight : level) {
        if (!flight.hit || !reaches(index, flight.surface, pending_[count].light)) continue;
        pending_[count].flight = &flight;
        aim(flight.surface, pending_[count].light, rays_[count]);
        ++count;
    }
    scene_.world.occluded({rays_.data(), count}, {blocked_.data(), count}, RayHint::coherent, scratch_,
                          kernel_);
    for (std::size_t i = 0; i < count; ++i) {
        Flight& flight = *pending_[i].flight;
        LightNode& light = pending_[i].light;
        if (blocked_[i] != 0) light.shadow = behind_blockers(rays_[i], flight.surface, flight.path.media);
        add_light(light, flight.surface, flight.terms);
    }
}

/// Ends the local terms of a flight and launches its branches.
void WhittedTracer::grow(Flight& flight) {
    limit_terms(flight.terms);
    if (!goes_on(flight.path, flight.surface, -1)) return;
    if (!has_room()) return branch(flight.path, flight.surface, flight.terms, -1);
    const Split split = split_at(flight.path, flight.surface, flight.terms, -1);
    flight.reflected_weight = split.reflected;
    flight.refracted_weight = split.refracted;
    if (split.reflected > 0.0f) {
        flight.reflected = static_cast<int>(flight_count_);
        reflect(flight.path, flight.surface, -1, launch().path);
    }
    if (split.refracted > 0.0f) {
        flight.refracted = static_cast<int>(flight_count_);
        transmit(flight.path, flight.surface, split, -1, launch().path);
    }
}

/// What branches bring, the youngest first: children stand behind their parents.
void WhittedTracer::gather() {
    for (std::size_t i = flight_count_; i-- > 0;) {
        Flight& flight = flights_[i];
        if (!flight.hit) continue;
        const auto brought = [&](int child, float weight) {
            return flights_[static_cast<std::size_t>(child)].terms.sum() * weight;
        };
        if (flight.reflected >= 0)
            flight.terms[Term::reflection] = brought(flight.reflected, flight.reflected_weight);
        if (flight.refracted >= 0)
            flight.terms[Term::transmission] = brought(flight.refracted, flight.refracted_weight);
        absorb(flight.path.media, flight.hit.t, flight.terms, -1);
    }
}

} // namespace glint
