/** Nested texts by key. */
export interface Words {
  readonly [key: string]: string | Words;
}
