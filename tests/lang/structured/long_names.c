//@ structured
// Names of more than 31 characters, where the output has other names for them.
// expect: v=42, w=3, x=12
#define MACRO_WITH_A_NAME_OF_MORE_THAN_31_LETTERS 10
#define MACRO_OF_PARAMETERS_WITH_MORE_THAN_31_LETTERS(parameter_with_a_name_of_more_than_31_letters) \
  (parameter_with_a_name_of_more_than_31_letters * 2)
enum enumeration_with_a_name_of_more_than_31_letters {
  constant_with_a_name_of_more_than_31_letters = 22
};
int v, w, x;
int prototype_with_a_name_of_more_than_31_letters(int and_its_parameter_has_such_a_name_as_well);
int prototype_with_a_name_of_more_than_31_letters(int and_its_parameter_has_such_a_name_as_well) {
  int local_with_a_name_of_more_than_31_letters_1 = and_its_parameter_has_such_a_name_as_well;
  int local_with_a_name_of_more_than_31_letters_2 = MACRO_WITH_A_NAME_OF_MORE_THAN_31_LETTERS;
  return local_with_a_name_of_more_than_31_letters_1 * 2 +
         local_with_a_name_of_more_than_31_letters_2;
}
int count() {
  static int static_with_a_name_of_more_than_31_letters_1;
  static int static_with_a_name_of_more_than_31_letters_2;
  static_with_a_name_of_more_than_31_letters_1 += 1;
  static_with_a_name_of_more_than_31_letters_2 += 2;
  return static_with_a_name_of_more_than_31_letters_1 + static_with_a_name_of_more_than_31_letters_2;
}
void t0() {
  int array_with_a_name_of_more_than_31_letters[2] = {5, 6};
  w = count();
  v = prototype_with_a_name_of_more_than_31_letters(5) + constant_with_a_name_of_more_than_31_letters;
  goto label_with_a_name_of_more_than_31_letters;
  v = 0;
label_with_a_name_of_more_than_31_letters:
  x = MACRO_OF_PARAMETERS_WITH_MORE_THAN_31_LETTERS(array_with_a_name_of_more_than_31_letters[1]);
}
