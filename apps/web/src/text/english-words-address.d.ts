declare module "virtual:english-words-address" {
  /** of the file of words in a build; "" while Corridor is developed */
  const address: string;
  export default address;
}
