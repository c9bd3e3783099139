#pragma once
// How far a render is: a bar on a terminal, else a plain line now and then, or JSON lines for render farms.

#include "console.h"

#include "glint/render.h"

#include <string>

namespace glint::cli {

enum class ProgressStyle { bar, plain, json, none };

/// `word` is "auto", "plain", "json" or "none".
ProgressStyle progress_style(const std::string& word);

class ProgressMeter {
  public:
    /// `task` is what is rendered, "" or "frame 7 of 0..119"; JSON names it too.
    ProgressMeter(Console& console, ProgressStyle style, std::string task = {});

    /// Takes the news and shows it if it is time to: ten times a second for a bar, every ten seconds for
    /// plain lines, once a second for JSON. One call at a time.
    void update(const Progress& progress);
    /// Erases the bar; JSON: says the last state.
    void finish();
    /// Share of the tiles that are done, 0 … 1.
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
