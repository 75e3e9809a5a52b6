/* A host for any family: it closes a card that it has not opened, which every family knows. */
#include HEADER

int main(void) {
  GT_Close();
  return 0;
}
