/* Two threads need two places. Each occupies its own first and then waits for the other's: when
   both have occupied theirs, both wait for ever. */
int loader_place;
int unloader_place;
int parts;

int loader()
{
  loader_place = 1;
  GT_WaitForVarEq(&unloader_place, 0);
  parts = parts + 1;
  loader_place = 0;
  return 0;
}

int unloader()
{
  unloader_place = 1;
  GT_WaitForVarEq(&loader_place, 0);
  parts = parts - 1;
  unloader_place = 0;
  return 0;
}
