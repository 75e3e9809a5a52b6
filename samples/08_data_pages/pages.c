/* Parameters and locals are stored in the data page of the thread. From the statement after
   GT_SetDataPage on the thread uses another page, where all its locals have other values. A value
   that is needed before and after the switch must be global. */
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

/* Waits, and so keeps its page in use for a while. */
int hold(int kept)
{
  GT_Delay(10);
  return kept;
}
