/** Layout of the page: bar, stage, transport, panel. */
export function App() {
  return <main />;
}
