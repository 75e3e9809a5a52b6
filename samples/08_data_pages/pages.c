/* Parameters and locals live in the data page of the thread. GT_SetDataPage gives the thread
   another page from the next statement on: all its locals are then other variables. What has to
   survive the switch must be global. */
int page;
int more;

int visit(int mark)
{
  page = 1;
lbl_loop:
  GT_SetDataPage(page);
  mark = page * 10;
  page = page + 1;
  more = page <= 3;
  if (more) goto lbl_loop;
  GT_SetDataPage(0);
  return mark;
}

/* Keeps its page for a while. */
int hold(int kept)
{
  GT_Delay(10);
  return kept;
}
