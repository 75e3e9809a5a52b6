// The motion-program language's types as C++ classes, for programs compiled by g++. Written from
// the rules, not from the machine: nothing of oncard may be included here. Generated files include
// this, turn `int` and `double` into these classes and then contain motion programs as they are.
#pragma once

#include <concepts>
#include <cstdio>
#include <initializer_list>
#include <vector>

/// Integer and fraction bits of the current program's double: 48 or 32.
inline int double_bits = 48;

/// What stops a thread; the number is its TThreadSts.error.
struct Fault {
  int code;
};
inline constexpr Fault kDivisionByZero{100};

/// The low `bits` of a number as two's complement.
inline long long Wrap(__int128 value, int bits) {
  const __int128 modulus = static_cast<__int128>(1) << bits;
  __int128 rest = value % modulus;
  if (rest < 0) rest += modulus;
  if (rest >= modulus / 2) rest -= modulus;
  return static_cast<long long>(rest);
}

struct Fixed;

/// A 32-bit int that wraps.
struct Int {
  long long value = 0;

  Int() = default;
  template <std::integral T>
  Int(T number) : value(Wrap(number, 32)) {}
  explicit Int(double number);
  explicit Int(Fixed number);
  operator long() const { return value; }  // as an array's index and in `if`

  Int operator~() const { return -1 - value; }
  Int operator!() const { return value == 0 ? 1 : 0; }
};

template <class A, class B>
concept IntOperands = (std::same_as<A, Int> && (std::same_as<B, Int> || std::integral<B>)) ||
                      (std::integral<A> && std::same_as<B, Int>);

#define ORACLE_INT_OPERATOR(op, expression)                     \
  template <class A, class B>                                   \
  requires IntOperands<A, B> Int operator op(A left, B right) { \
    const __int128 a = Int(left).value;                         \
    const __int128 b = Int(right).value;                        \
    return Int{Wrap(expression, 32)};                           \
  }

inline __int128 NotZero(__int128 divisor) {
  if (divisor == 0) throw kDivisionByZero;
  return divisor;
}

// The machine's words are written as arithmetic on the unbounded numbers they stand for.
inline __int128 Power2(__int128 count) {
  return static_cast<__int128>(1) << ((count % 32 + 32) % 32);
}
inline __int128 FloorDivide(__int128 a, __int128 b) {
  return a / b - (a % b != 0 && (a < 0) != (b < 0));
}

ORACLE_INT_OPERATOR(+, a + b)
ORACLE_INT_OPERATOR(-, a - b)
ORACLE_INT_OPERATOR(*, a* b)
ORACLE_INT_OPERATOR(/, a / NotZero(b))
ORACLE_INT_OPERATOR(%, a % NotZero(b))
ORACLE_INT_OPERATOR(&, a& b)
ORACLE_INT_OPERATOR(|, a | b)
ORACLE_INT_OPERATOR(^, a ^ b)
ORACLE_INT_OPERATOR(<<, a* Power2(b))
ORACLE_INT_OPERATOR(>>, FloorDivide(a, Power2(b)))
ORACLE_INT_OPERATOR(&&, a != 0 && b != 0)
ORACLE_INT_OPERATOR(||, a != 0 || b != 0)
ORACLE_INT_OPERATOR(==, a == b)
ORACLE_INT_OPERATOR(!=, a != b)
ORACLE_INT_OPERATOR(<, a < b)
ORACLE_INT_OPERATOR(<=, a <= b)
ORACLE_INT_OPERATOR(>, a > b)
ORACLE_INT_OPERATOR(>=, a >= b)

inline Int abs(Int x) { return x.value < 0 ? -x.value : x.value; }

/// A number with 16 fractional bits; `raw` is the number times 65536.
struct Fixed {
  long long raw = 0;

  Fixed() = default;
  Fixed(double literal) {
    const double scaled = literal * 65536;
    raw = static_cast<long long>(scaled < 0 ? scaled - 0.5 : scaled + 0.5);
  }
  template <std::integral T>
  Fixed(T literal) : raw(static_cast<long long>(literal) * 65536) {}
  explicit Fixed(Int number)
      : raw(Wrap(static_cast<__int128>(number.value) * 65536, double_bits)) {}
  static Fixed FromRaw(__int128 number) {
    Fixed result;
    result.raw = Wrap(number, double_bits);
    return result;
  }

  friend Fixed operator+(Fixed a, Fixed b) { return FromRaw(static_cast<__int128>(a.raw) + b.raw); }
  friend Fixed operator-(Fixed a, Fixed b) { return FromRaw(static_cast<__int128>(a.raw) - b.raw); }
  friend Fixed operator*(Fixed a, Fixed b) {
    return FromRaw(static_cast<__int128>(a.raw) * b.raw / 65536);
  }
  friend Fixed operator/(Fixed a, Fixed b) {
    return FromRaw(static_cast<__int128>(a.raw) * 65536 / NotZero(b.raw));
  }
  friend Int operator==(Fixed a, Fixed b) { return a.raw == b.raw; }
  friend Int operator!=(Fixed a, Fixed b) { return a.raw != b.raw; }
  friend Int operator<(Fixed a, Fixed b) { return a.raw < b.raw; }
  friend Int operator<=(Fixed a, Fixed b) { return a.raw <= b.raw; }
  friend Int operator>(Fixed a, Fixed b) { return a.raw > b.raw; }
  friend Int operator>=(Fixed a, Fixed b) { return a.raw >= b.raw; }
};

inline Int::Int(Fixed number) : value(Wrap(number.raw / 65536, 32)) {}
inline Int::Int(double number) : Int(Fixed(number)) {}
inline Fixed fabs(Fixed x) { return Fixed::FromRaw(x.raw < 0 ? -x.raw : x.raw); }

struct TTrapPrm {
  Fixed acc, dec, velStart;
  Int smoothTime;
};
struct TJogPrm {
  Fixed acc, dec, smooth;
};
struct TPid {
  Fixed kp, ki, kd, kvff, kaff;
  Int integralLimit, derivativeLimit, limit;
};

// --- Setting and reporting variables
// ---------------------------------------------------------------

inline std::vector<long long> report;

inline void Set(Int& variable, long long initial) { variable.value = initial; }
inline void Set(Fixed& variable, long long initial) { variable.raw = initial; }
inline void Put(Int variable) { report.push_back(variable.value); }
inline void Put(Fixed variable) { report.push_back(variable.raw); }
template <class T>
void SetArray(T* array, std::initializer_list<long long> initial) {
  for (const long long value : initial) Set(*array++, value);
}
template <class T>
void PutArray(const T* array, int size) {
  for (int i = 0; i < size; ++i) Put(array[i]);
}

/// Reports a function's variables when it ends, in whatever way.
template <class Action>
struct AtEnd {
  Action action;
  ~AtEnd() { action(); }
};
template <class Action>
AtEnd(Action) -> AtEnd<Action>;

/// Calls a function and reports its result and its fault.
template <class Function>
void Call(Function function) {
  try {
    if constexpr (std::same_as<decltype(function()), void>) {
      function();
      report.push_back(0);
    } else {
      Put(function());
    }
    report.push_back(0);
  } catch (const Fault& fault) {
    report.push_back(0);
    report.push_back(fault.code);
  }
}

// --- Threads
// --------------------------------------------------------------------------------------

/// A motion program's function with its variables, executed statement by statement.
struct Thread {
  static constexpr unsigned kEnded = ~0u;
  unsigned next = 0;  ///< statement
  unsigned size = 0;  ///< statements of the function
  long long result = 0;
  long long fault = 0;

  virtual ~Thread() = default;
  virtual void Statement() = 0;
  virtual void Report() = 0;

  bool Alive() const { return next < size; }
  void Return(Int value) { Return(value.value); }
  void Return(Fixed value) { Return(value.raw); }
  void Return(long long value) {
    result = value;
    next = kEnded;
  }
  void Step() {
    try {
      Statement();
    } catch (const Fault& reason) {
      fault = reason.code;
      next = kEnded;
    }
  }
};

/// First the threads named by the digits of `order`, one statement each, those that have ended
/// skipped; then all in turn, `quantum` statements each, until all have ended.
inline void RunThreads(const std::vector<Thread*>& threads, const char* order, int quantum) {
  for (; *order != 0; ++order) {
    Thread& thread = *threads[static_cast<unsigned>(*order - '0')];
    if (thread.Alive()) thread.Step();
  }
  for (bool any = true; any;) {
    any = false;
    for (Thread* thread : threads) {
      for (int i = 0; i < quantum && thread->Alive(); ++i) {
        thread->Step();
        any = true;
      }
    }
  }
  for (Thread* thread : threads) {
    thread->Report();
    report.push_back(thread->result);
    report.push_back(thread->fault);
  }
}

/// Ends the line of one program.
inline void PrintReport() {
  for (const long long value : report) std::printf("%lld ", value);
  std::printf("\n");
  report.clear();
}
