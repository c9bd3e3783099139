// Messages and exit codes of exceptions that no scene small enough for a test provokes.

#include "../common/out_of_memory.h"
#include "commands.h"
#include "failures.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace glint::cli {
namespace {

/// What stderr says of an exception, and the exit code.
template <class Exception>
std::pair<std::string, int> report(const Exception& exception) {
    Console console(Verbosity::normal, false);
    int code = 0;
    testing::internal::CaptureStderr();
    try {
        throw exception;
    } catch (...) {
        code = report_failure(console);
    }
    return {testing::internal::GetCapturedStderr(), code};
}

TEST(Failures, ALimitOfTheLibraryIsNamed) {
    const auto [text, code] = report(std::length_error("the leaves of a mesh exceed 512 MiB"));
    EXPECT_NE(text.find("error: the leaves of a mesh exceed 512 MiB\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("out of memory"), std::string::npos) << text;
    EXPECT_EQ(code, exit_code::resource);
}

TEST(Failures, MemoryThatIsLackingIsNoDefect) {
    const auto [text, code] = report(std::bad_alloc());
    EXPECT_NE(text.find("error: out of memory\n"), std::string::npos) << text;
    EXPECT_EQ(code, exit_code::resource);
}

TEST(Failures, ThreadsThatCannotBeStartedAreNoDefect) {
    const auto [text, code] =
        report(std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again)));
    EXPECT_NE(text.find("error: the system starts no more threads\n"), std::string::npos) << text;
    EXPECT_EQ(code, exit_code::resource);
}

void allocate_too_much() { throw std::bad_alloc(); }

TEST(FailuresDeathTest, MemoryThatIsLackingWhereNothingMayBeThrownEndsLikeElsewhere) {
    EXPECT_EXIT(
        {
            end_if_bad_alloc_is_uncaught();
            []() noexcept { allocate_too_much(); }();
        },
        testing::ExitedWithCode(exit_code::resource), "error: out of memory");
}

TEST(Failures, EveryDiagnosticOfAnErrorIsPrinted) {
    std::vector<Diagnostic> diagnostics(2);
    diagnostics[0].message = "one";
    diagnostics[1].message = "two";
    const auto [text, code] = report(Error(ErrorKind::input, diagnostics));
    EXPECT_NE(text.find("error: one\n"), std::string::npos) << text;
    EXPECT_NE(text.find("error: two\n"), std::string::npos) << text;
    EXPECT_EQ(code, exit_code::input);
}

TEST(Failures, AnyOtherExceptionIsADefect) {
    const auto [text, code] = report(std::logic_error("x"));
    EXPECT_NE(text.find("internal error: x"), std::string::npos) << text;
    EXPECT_EQ(code, exit_code::internal);
}

} // namespace
} // namespace glint::cli
