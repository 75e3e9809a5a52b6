//@ structured
int hex = 0xFF, bits = 0b101, octal = 017, zero = 0, large = 2147483647, small = -2147483648;
unsigned all = 0xFFFFFFFF, most = 4294967295U;
long suffixes = 12L + 12l + 0x1FUL + 12lu + 12Ul;
int letter = 'a', line = '\n', quote = '\'', null = '\0', code = '\x41', octal_code = '\101';
double half = .5, three = 3., thousand = 1e3;
bool flag = true, other = false;
