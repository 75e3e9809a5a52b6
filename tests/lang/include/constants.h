#define LIMIT 12
int shared;
