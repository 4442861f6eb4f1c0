/**
 * A part of the worker that loads on first use. Its uses wait until it has loaded and run in the
 * order of the calls. After a failure, the next use loads it again.
 */
export class Lazy<Part> {
  readonly #load: () => Promise<Part>;
  readonly #guarded: (work: () => void) => void;
  #loading: Promise<Part> | null = null;
  #loaded: Part | null = null;

  /**
   * @param load imports and creates the part
   * @param guarded calls a function and handles its errors
   */
  constructor(load: () => Promise<Part>, guarded: (work: () => void) => void) {
    this.#load = load;
    this.#guarded = guarded;
  }

  /** The part; null until it has loaded. */
  get loaded(): Part | null {
    return this.#loaded;
  }

  /** Whether the part has loaded, or is loading. */
  get isRequested(): boolean {
    return this.#loading !== null;
  }

  /**
   * Calls a function with the part.
   * @param onFailure is called instead if the part does not load
   */
  use(use: (part: Part) => void, onFailure: (error: unknown) => void = () => undefined): void {
    this.#loading ??= this.#start();
    const loading = this.#loading;
    loading.then(
      (part) => this.#guarded(() => use(part)),
      (error: unknown) => {
        // An earlier use that failed with this one may have started the next attempt.
        if (this.#loading === loading) this.#loading = null;
        this.#guarded(() => onFailure(error));
      },
    );
  }

  async #start(): Promise<Part> {
    this.#loaded = await this.#load();
    return this.#loaded;
  }
}
