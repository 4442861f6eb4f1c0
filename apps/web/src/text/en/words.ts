/** Words by key, nested; their leaves are texts. */
export interface Words {
  readonly [key: string]: string | Words;
}
