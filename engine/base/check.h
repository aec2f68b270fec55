// Checks for broken contracts: a programmer's mistake stops the program, a bad file never does.
#pragma once

namespace enfilade {

/// Where an attempt is under way in this thread (base/attempt.h), ends that attempt. Else removes unfinished files,
/// prints "file:line: broken contract: text" to stderr and aborts.
[[noreturn]] void contract_broken(const char* file, int line, const char* text);

}  // namespace enfilade

/// Always on. For cheap checks at the doors of a module.
#define ENFILADE_CHECK(condition) \
    ((condition) ? static_cast<void>(0) : ::enfilade::contract_broken(__FILE__, __LINE__, #condition))

/// On where NDEBUG is not defined. For checks inside loops.
#ifdef NDEBUG
#define ENFILADE_DCHECK(condition) static_cast<void>(sizeof(condition))
#else
#define ENFILADE_DCHECK(condition) ENFILADE_CHECK(condition)
#endif
