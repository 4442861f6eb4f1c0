/**
 * Loads the parser of stored projects: before the page opens if a project is stored, otherwise in
 * the background.
 */
import type { ReadProject } from "./project-storage.ts";

export class ProjectReader {
  #read: ReadProject | null = null;

  /** null until it has loaded */
  get read(): ReadProject | null {
    return this.#read;
  }

  /** @throws if its file does not load; another call retries */
  async load(): Promise<void> {
    const { readProject } = await import("./read-project.ts");
    this.#read = readProject;
  }
}
