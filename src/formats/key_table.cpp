#include "formats/key_table.h"

#include "formats/scene_words.h"

#include <algorithm>

namespace glint {
namespace {

bool has_word(std::string_view words, std::string_view word) {
    const auto all = split_words(words);
    return std::find(all.begin(), all.end(), word) != all.end();
}

} // namespace

std::string Range::words() const {
    const bool below = low > -std::numeric_limits<double>::infinity();
    const bool above = high < std::numeric_limits<double>::infinity();
    if (below && above && !low_open && !high_open) return "between " + show(low) + " and " + show(high);
    std::string text;
    if (below) text = (low_open ? "above " : "at least ") + show(low);
    if (below && above) text += " and ";
    if (above) text += (high_open ? "below " : "at most ") + show(high);
    return text;
}

std::string TableSpec::header(std::string_view name_of_it) const {
    switch (form) {
    case TableForm::root:
        return "the file's top";
    case TableForm::one:
        return "[" + std::string(name) + "]";
    case TableForm::named:
        return "[" + std::string(name) + "." + std::string(name_of_it) + "]";
    case TableForm::list:
        return "[[" + std::string(name) + "]]";
    case TableForm::entry:
        break;
    }
    return "an entry of " + in_quotes(name);
}

const TableSpec* find_table(std::string_view name) {
    for (const TableSpec& table : table_specs())
        if (table.name == name) return &table;
    return nullptr;
}

const KeySpec* find_key(const TableSpec& table, std::string_view key, std::string_view type) {
    for (const KeySpec& spec : table.keys)
        if (spec.key == key && (type.empty() || spec.types.empty() || has_word(spec.types, type)))
            return &spec;
    return nullptr;
}

std::vector<std::string> key_names(const TableSpec& table, std::string_view type) {
    std::vector<std::string> names;
    for (const KeySpec& spec : table.keys) {
        const bool new_one = names.empty() || names.back() != spec.key;
        if (new_one && find_key(table, spec.key, type)) names.emplace_back(spec.key);
    }
    return names;
}

std::vector<std::string> split_words(std::string_view text) {
    std::vector<std::string> words;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        if (end > begin) words.emplace_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return words;
}

} // namespace glint
