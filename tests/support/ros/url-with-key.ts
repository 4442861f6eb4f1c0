import { createdKeySchema, type Registration } from "@corridor/protocol";

/** Makes a key of a robot for URLs. @returns the URL for ROS clients, with the key in its path */
export async function urlWithKey(
  origin: string,
  { id, ownerKey }: Registration,
  kind: "drive" | "watch" = "drive",
): Promise<string> {
  const answer = await fetch(`${origin}/api/v1/robots/${id}/keys`, {
    method: "POST",
    headers: { Authorization: `Bearer ${ownerKey}`, "Content-Type": "application/json" },
    body: JSON.stringify({ kind, use: "url" }),
  });
  const { urls } = createdKeySchema.parse(await answer.json());
  const ros = urls?.ros ?? null;
  if (ros === null) throw new Error("the key has no URL for ROS");
  return ros;
}
