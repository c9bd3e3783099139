// Replaces the Embree peers in builds without Embree.

#include "builders.h"
#include "peer.h"

namespace glint::bench {

std::vector<Peer> embree_peers(const Model&, Group, const std::string&) { return {}; }

std::vector<Builder> embree_builders() { return {}; }

std::string embree_version() { return {}; }

} // namespace glint::bench
