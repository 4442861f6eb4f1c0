/** A client that sends 1,000 messages that nobody can read, and is closed again and again. */
export async function sendWrongMessages(url: string): Promise<void> {
  for (let sent = 0; sent < 1_000; sent += 11) {
    const socket = new WebSocket(url);
    const closed = new Promise<number>((resolve) => {
      socket.onclose = ({ code }) => resolve(code);
    });
    await new Promise((resolve) => (socket.onopen = resolve));
    socket.send(`{"op":"publish","topic":"/cmd_vel","msg":${"[".repeat(256)}${"]".repeat(256)}}`);
    for (let n = 1; n <= 10; n += 1) socket.send("nonsense");
    const code = await closed;
    if (code !== 4400) throw new Error(`closed with ${code}`);
  }
}
