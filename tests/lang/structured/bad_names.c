//@ structured
int name_with_more_than_thirty_one_letters; // expect error MP002
