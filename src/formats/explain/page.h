#pragma once
// Data of the page of explanation_html(): rays consist of a shape (texts and formulas, shared by many rays)
// and numbers. The page evaluates the formulas; only given quantities, and results that JavaScript would
// round differently, are stored.

#include "formats/embedded.h"
#include "glint/explanation.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace glint::formats {

inline std::string_view page_style() { return embedded_text("formats/explain/page.css"); }
/// Plain JavaScript without libraries or network access.
inline std::string_view page_script() { return embedded_text("formats/explain/page.js"); }

class PageData {
  public:
    /// Adds a pixel: its colour and the rays of its first sample.
    void add(const Explanation& explanation);

    /// Number of rays that can be shown.
    std::size_t rays() const { return complete_; }
    /// Compressed data with the `count` heaviest rays and everything they need. `head` is the start of a JSON
    /// object: "{…,".
    std::string packed(const std::string& head, std::size_t count) const;

  private:
    enum class Source { formula, stored, constant, link };
    struct Ray {
        std::uint32_t shape = 0;
        bool complete = true;     ///< whether it has steps
        std::int32_t parent = -1; ///< index within its pixel
        std::int32_t reflected = -1;
        std::int32_t refracted = -1;
        float weight = 0;
        glm::vec3 radiance{0.0f};
        std::size_t first = 0; ///< index of its first number
    };
    struct PixelRecord {
        std::size_t first_ray = 0;
        std::size_t rays = 0;
        std::array<glm::vec3, 1 + term_count> sums{}; ///< colour and terms
    };

    std::uint32_t shape_of(const ExplainedRay& ray);
    std::string steps_of(const ExplainedRay& ray, const std::vector<const std::vector<Step>*>& lists);
    std::string light_of(const ExplainedRay& ray, const ExplainedLight& light);
    std::string source_of(const ExplainedRay& ray, const Step& step);
    std::string step_number(const Step& step);
    int constant_number(const Quantity& value);
    void store(const Quantity& value);
    std::vector<bool> heaviest(std::size_t count) const;
    std::string json(const std::string& head) const;

    std::vector<PixelRecord> pixels_;
    std::vector<Ray> rays_;
    std::size_t complete_ = 0;
    std::vector<float> numbers_;
    std::vector<std::uint32_t> sizes_; ///< by shape: count of numbers per ray
    std::vector<std::string> shapes_;
    std::map<std::string, std::uint32_t> shape_numbers_;
    std::vector<std::string> steps_;
    std::map<std::string, std::size_t> step_numbers_;
    std::vector<std::string> constants_;
    std::map<std::string, int> constant_numbers_;
};

} // namespace glint::formats
