/**
 * Takes out of i18next the sentences by which it explains mistakes to developers: they are shown on no
 * screen, and are more than a kilobyte of what a first visit has to load.
 */
import type { Plugin } from "vite";

const LIBRARY = /\/(?:i18next\/dist\/esm\/i18next|react-i18next\/dist\/es\/\w+)\.js$/;
/** An argument that is a sentence: at least four plain words in a row, between two quotes on one line. */
const SENTENCE =
  /(?<=\(|, |^\s+)(['"`])(?=(?:(?!\1)[^\n])*?[a-z]+ [a-z]+ [a-z]+ [a-z]+)(?:(?!\1)[^\\\n]|\\.)+\1(?=\)|,)/gm;

export function leanWords(): Plugin {
  return {
    name: "corridor-lean-words",
    apply: "build",
    transform: {
      filter: { id: LIBRARY },
      handler: (code) => ({ code: code.replaceAll(SENTENCE, '""'), map: null }),
    },
  };
}
