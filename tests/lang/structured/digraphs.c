//@ structured
// Two characters for one, as in C.
%:define LAST(a) a<:2:>
int list<:3:> = <%1, 2, 3%>, v;
void t0(void) <%
  v = LAST(list) + list<:0:>;
%>
// expect: v=4
