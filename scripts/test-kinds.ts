/** What unit tests must not do, because they are quick and share their workers. */
import { importsOf, resolve, withoutComments, type Sources } from "./boundaries.ts";

const opening = /^node:(?:net|http|https|sqlite)$|\/(?:testing\/test-relay|sqlite\/.+)\.ts$/;
const typeImport = /^(?:import|export) type [^;]*;/gm;

/**
 * Tests that open a socket or an SQLite file, by themselves or with a helper: they are integration
 * tests.
 *
 * @param sources tests, and the helpers that only tests import
 */
export function testsThatOpen(sources: Sources): string[] {
  const opens = (file: string, trail: readonly string[]): boolean => {
    const source = sources.get(file)?.replaceAll(typeImport, "");
    if (source === undefined || trail.includes(file)) return false;
    if (/\.listen\((?:\d|port\b)/.test(withoutComments(source))) return true;
    return importsOf(source).some(
      (name) =>
        opening.test(name) ||
        (name.startsWith(".") && opens(resolve(file, name), [...trail, file])),
    );
  };
  return [...sources.keys()].filter((file) => /\.test\.tsx?$/.test(file) && opens(file, []));
}

/** Tests that replace timers, globals or methods for those after them. */
export function testsThatKeepStubs(sources: Sources): string[] {
  const pairs = [
    [/vi\.useFakeTimers\(/, /vi\.useRealTimers\(/],
    [/vi\.stubGlobal\(/, /vi\.unstubAllGlobals\(/],
    [/vi\.spyOn\(/, /mockRestore\(|vi\.restoreAllMocks\(/],
  ] as const;
  return [...sources]
    .filter(([, source]) =>
      pairs.some(([replace, restore]) => replace.test(source) && !restore.test(source)),
    )
    .map(([file]) => file);
}
