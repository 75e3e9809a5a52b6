//@ structured
int name_with_more_than_thirty_one_letters; // expect error MP002
int a_name_of_exactly_31_characters;
void a_thread_of_exactly_31_character() {} // expect error MP002
void a_thread_of_exactly_31_letters_() {}
