/** Provides the language choice to components. */
import { createContext, useContext } from "react";
import type { LanguageChoice } from "./preferences/language.ts";

const LanguageContext = createContext<LanguageChoice | null>(null);
export const LanguageProvider = LanguageContext.Provider;

export function useLanguageChoice(): LanguageChoice {
  const choice = useContext(LanguageContext);
  if (choice === null) throw new Error("useLanguageChoice needs a LanguageProvider above it");
  return choice;
}
