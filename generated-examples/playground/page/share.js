// What leaves the page: a link that holds the table, files, the clipboard. All of it stays on this machine until its user passes it on.

// Characters of a table that a link may hold once it is unpacked.
const LONGEST_LINK = 200_000;

const packed = async (bytes, stream) => new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());

async function toFragment(text) {
  const bytes = await packed(new TextEncoder().encode(text), new CompressionStream("deflate-raw"));
  const letters = btoa(String.fromCharCode(...bytes));
  return "#t=" + letters.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

// The table of a link; null where there is none or where it is no table of ours.
async function fromFragment(fragment) {
  if (!fragment.startsWith("#t=")) return null;
  try {
    const bytes = Uint8Array.from(atob(fragment.slice(3).replaceAll("-", "+").replaceAll("_", "/")), (c) => c.charCodeAt(0));
    const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw")).getReader();
    const decoder = new TextDecoder();
    let text = "";
    for (;;) {
      const { done, value } = await reader.read();
      if (done) return text + decoder.decode();
      text += decoder.decode(value, { stream: true });
      if (text.length > LONGEST_LINK) { await reader.cancel(); return null; }
    }
  } catch { return null; }
}

function download(name, text, type) {
  const link = make("a", { href: URL.createObjectURL(new Blob([text], { type })), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

async function copy(text, button) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    // Without permission: by a selection.
    const area = make("textarea", { class: "hidden" });
    area.value = text;
    document.body.append(area);
    area.select();
    document.execCommand("copy");
    area.remove();
  }
  const before = button.textContent;
  button.textContent = word("copied");
  setTimeout(() => { if (button.textContent === word("copied")) button.textContent = before; }, 1500);
}
