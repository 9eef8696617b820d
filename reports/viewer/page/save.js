// The edits leave the page as a download; where a browser refuses one, as text to copy.
function editsFileName() {
  return `${fileName.replace(/\.[^.]*$/, "") || "drawing"}.edits.json`;
}

function saveEdits() {
  const text = app.edits.toText(), name = editsFileName();
  const address = URL.createObjectURL(new Blob([text], {type: "application/json"}));
  const link = create("a", {href: address, download: name});
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
  byId("saved-note").replaceChildren(
      `Saved as ${name}. If your browser has kept it from you, copy the text. Plan with it: `,
      create("code", {}, `oxturn draw ${data.file} --edits ${name} --viewer ${name.replace(".edits.json", ".html")}`));
  byId("saved-text").value = text;
  byId("saved").showModal();
}

function prepareSaving() {
  byId("save").onclick = saveEdits;
  byId("close").onclick = () => byId("saved").close();
  byId("copy").onclick = async () => {
    byId("saved-text").select();
    try {
      await navigator.clipboard.writeText(byId("saved-text").value);
      byId("copy").textContent = "Copied";
    } catch {
      byId("copy").textContent = document.execCommand("copy") ? "Copied" : "Press Ctrl C";
    }
  };
}
