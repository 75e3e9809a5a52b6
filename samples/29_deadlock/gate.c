/* Two threads need two places each. Each occupies one and then waits for the one that the other
   thread occupies first: once both have occupied their first place, both wait for ever. */
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
