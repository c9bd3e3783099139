#pragma once
// The progress of a render: a bar on a terminal, plain lines elsewhere, or JSON lines for render farms.

#include "console.h"

#include "glint/render.h"

#include <string>

namespace glint::cli {

enum class ProgressStyle { bar, plain, json, none };

/// `name` is "auto", "plain", "json" or "none".
ProgressStyle progress_style(const std::string& name);

class ProgressMeter {
  public:
    /// `task` is what is rendered, "" or "frame 7 of 0..119"; JSON names it too.
    ProgressMeter(Console& console, ProgressStyle style, std::string task = {});

    /// Shows progress at an interval: ten times a second for a bar, every ten seconds for plain lines, once a
    /// second for JSON. Not thread-safe.
    void update(const Progress& progress);
    /// Erases the bar; for JSON, writes the last state.
    void finish();
    /// Fraction of the tiles that are done.
    double fraction() const;

  private:
    void show();

    Console& console_;
    ProgressStyle style_;
    std::string task_;
    Progress last_;
    double next_show_; ///< seconds of rendering
};

} // namespace glint::cli
