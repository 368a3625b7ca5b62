#include "app/process/told_exit.hpp"

#include <cstdlib>
#include <fstream>
#include <string>
#include <system_error>
#include <unistd.h>

namespace stria {
namespace {

constexpr const char* variable = "STRIA_TELL_EXIT";

}  // namespace

ToldExit::ToldExit() {
    std::error_code problem;
    std::string name = (std::filesystem::temp_directory_path(problem) / "stria_exit.XXXXXX").string();
    const int file = problem ? -1 : mkstemp(name.data());
    if (file < 0) return;
    close(file);
    file_ = name;
    setenv(variable, name.c_str(), 1);
}

ToldExit::~ToldExit() {
    if (file_.empty()) return;
    unsetenv(variable);
    std::error_code problem;
    std::filesystem::remove(file_, problem);
}

int ToldExit::code_or(int code) const {
    int told = 0;
    return code == 0 && std::ifstream(file_) >> told ? told : code;
}

int tell_exit(int code) {
    const char* file = std::getenv(variable);
    if (code == 0 || file == nullptr || !std::filesystem::exists(file)) return code;  // not on this machine
    std::ofstream out(file);
    return out << code << std::flush ? 0 : code;
}

}  // namespace stria
