/* The part of <tchar.h> that console hosts use. Characters are bytes. */
#ifndef ONCARD_COMPAT_TCHAR_H_
#define ONCARD_COMPAT_TCHAR_H_

typedef char TCHAR;
typedef char _TCHAR;

#define _T(text) text
#define _TEXT(text) text
#define _tmain main
#define _tprintf printf

#endif
