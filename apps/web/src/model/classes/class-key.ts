/** Entry of the tab's storage with the key of the student. Separate, because each page reads it. */
export const CLASS_KEY = "corridor.class";
